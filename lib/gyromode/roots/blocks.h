#pragma once

#include "gyromode/roots/lifted_impedance.h"

#include <vector>

namespace gyromode {

/// Coordinates of a Lifted impedance that are coupled to each other and to no other, at any frequency, by the Couplings
/// that its parts state. Where they part into two groups of which entries within are real and between imaginary (Boland
/// & Janssens 1979, Eq. 8), T = diag(1, −j) makes the block real symmetric.
struct Block {
  std::vector<Index> coordinates;
  std::vector<bool> in_quadrature;  ///< a coordinate; all false without a partition
  bool real = true;
  /// coordinates of equal blocks of one coordinate that this stands for as well: patterns of equal parts that leave the
  /// rest at peace
  std::vector<Index> equal_blocks;

  Index copies() const { return 1 + static_cast<Index>(equal_blocks.size()); }
  Index size() const { return static_cast<Index>(coordinates.size()); }
};

std::vector<Block> blocks_of(const Couplings& couplings);
inline std::vector<Block> blocks_of(const LiftedImpedance& impedance) { return blocks_of(impedance.couplings()); }

/// A block at one frequency: its eigenvalues, ascending, and n₋ of what it stands for.
struct BlockState {
  Vector eigenvalues;
  Index poles_below = 0;  ///< Σ poles_below of its coordinates
  Index count = 0;        ///< J(ω) = n₋(matrix) + Σ poles_below, of one copy
  double nearest = 0;     ///< eigenvalue of least modulus
  double size = 1;        ///< of the entries: the largest modulus of an eigenvalue, at least 1
};
BlockState state_of(const Block& block, const Lifted& lifted);

/// An eigenvalue with its vector in the coordinates of the Lifted matrix (zero elsewhere), 2-norm 1.
struct BlockEigenpair {
  double value = 0;
  ComplexVector vector;
};
/// The `position`-th, ascending.
BlockEigenpair eigenpair(const Block& block, const Lifted& lifted, Index position);

}  // namespace gyromode
