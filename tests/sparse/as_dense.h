#pragma once

#include "gyromode/sparse/sparse_system.h"

#include <string>

namespace gyromode::support {

/// What is on and below the diagonal of A, or only below.
SparseMatrix lower_of(const Matrix& a, bool with_diagonal = true);

/// Expects of the sparse engine what the dense one says of the lowest quarter of the modes: frequencies, energy signs,
/// zero modes, class, verdict, and that they are complete. @returns false where the dense engine gives no verdict
bool expect_as_dense(const Matrix& m, const Matrix& g, const Matrix& k, const std::string& which);

}  // namespace gyromode::support
