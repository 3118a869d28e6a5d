#pragma once

#include "gyromode/lapack/types.h"

namespace gyromode {

/// Sign class of a symmetric matrix. `semidefinite` is positive semidefinite and singular.
enum class Sign { positive, semidefinite, indefinite };

/// Inertia of a symmetric matrix K, with a basis of its null space.
struct Definiteness {
  Index negative = 0;
  Index zero = 0;
  Index positive = 0;
  Matrix null_space;   ///< n × zero, columns of 2-norm 1 spanning null(K)
  double margin = 1;   ///< of the equilibrated K: smallest over largest |eigenvalue| not called zero; beyond order 256 a reciprocal condition (1-norm)

  Sign sign() const;
};

/// Inertia of a symmetric matrix (n × n, 0 × 0 allowed). K is equilibrated first, K̂ = D K D with |K̂| rows near 1, so units do not matter.
/// Eigenvalues λ of K̂ with |λ| ≤ 8 n ε max|λ| are zero: a backward error of that size makes them so. Beyond order 256 a Cholesky, then a Bunch–Kaufman
/// factorisation decides where pivots and condition both leave no doubt.
Definiteness definiteness(const Matrix& k);

}  // namespace gyromode
