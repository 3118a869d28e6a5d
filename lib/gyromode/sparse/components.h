#pragma once

#include "gyromode/sparse/matrix.h"

#include <vector>

namespace gyromode::sparse {

/// Coordinates that a symmetric matrix, by its lower triangle, couples directly or by way of others: each set
/// ascending, and the sets by their first coordinate. Entries that are 0 couple nothing.
std::vector<std::vector<Index>> components_of(const SparseMatrix& lower);

}  // namespace gyromode::sparse
