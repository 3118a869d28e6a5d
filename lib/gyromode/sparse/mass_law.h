#pragma once

#include "gyromode/base/labels.h"
#include "gyromode/sparse/matrix.h"

#include <vector>

namespace gyromode::sparse {

/// Whether M, by its lower triangle, is positive semidefinite to rounding and not definite: of its factorisation or of
/// the digits of a file, 10⁻¹² of every diagonal entry. Elements of reduced integration leave motions without mass.
/// `places` of the nodes and `node` of every coordinate are an order of elimination. @throws LawBroken where M is
/// indefinite beyond that; TooLarge
bool is_singular_mass(const SparseMatrix& mass, const std::vector<int>& places, const std::vector<int>& node, const Labels& labels);

}  // namespace gyromode::sparse
