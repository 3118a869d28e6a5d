#pragma once

#include "gyromode/sparse/sparse_system.h"
#include "gyromode/structure/structure.h"

#include <array>
#include <vector>

namespace gyromode::sparse {

/// The partition of a system: which coordinates are in phase, which in quadrature.
struct Groups {
  bool partition = false;                  ///< there is one; without, all are in phase
  std::vector<bool> across;                ///< of every coordinate, whether it is in quadrature
  std::array<std::vector<Index>, 2> rows;  ///< in phase, in quadrature, ascending
};
Groups groups_of(const Structure& structure, Index n);

/// The order of elimination of some coordinates of a system, as those who factor a block of it want it.
std::vector<int> elimination_order(const SparseSystem& system, const std::vector<Index>& rows);

/// [0, B; Bᵀ, 0] by what is below its diagonal, B the block of G that has rows in phase: C u is (Bẏ, Bᵀx) of u = (x,
/// ẏ).
SparseMatrix coupling_of(const SparseSystem& system, const Groups& groups);

}  // namespace gyromode::sparse
