#pragma once

#include "gyromode/structure/definiteness.h"

#include <memory>
#include <string_view>

namespace gyromode {

/// D K D = L Lᵀ of a positive definite K, D of powers of two with a unit diagonal; L lower triangular, zeros above.
struct PositiveFactor {
  Vector scale;
  Matrix l;
};

/// The same with what its computation leaves: a basis of the null space, how far the count is from another, a factor.
struct StiffnessInertia : InertiaOfK {
  Index positive = 0;
  Matrix null_space;  ///< n × zero, columns of 2-norm 1 spanning null(K)
  /// up to order 256 the least |pivot| over the terms it is made of; beyond, of the equilibrated K, smallest over
  /// largest |eigenvalue| not called zero, or a reciprocal condition (1-norm)
  double margin = 1;
  bool doubtful = false;                         ///< what was not called zero comes within a factor of eight of it
  std::shared_ptr<const PositiveFactor> factor;  ///< where a Cholesky factorisation has decided
};

/// Inertia of a symmetric matrix (n × n, 0 × 0 allowed). Up to order 64 zero is decided entry by entry (RankedFactor),
/// so that neither units nor gradings matter. Beyond, a Cholesky, then a Bunch–Kaufman factorisation decides where
/// pivots and condition both leave no doubt; else again entry by entry up to order 256, and beyond eigenvalues λ of the
/// equilibrated K with |λ| ≤ 8 n ε max|λ| are zero.
StiffnessInertia inertia_of_k(const Matrix& k);

}  // namespace gyromode
