#pragma once

#include "gyromode/lapack/reflectors.h"

namespace gyromode::dense {

/// Z = Q T Qᵀ for a real skew matrix Z (n × n, strictly lower triangle read) with T skew tridiagonal and Q orthogonal,
/// kept as reflectors. T(k+1, k) = β_k, T(k, k+1) = −β_k.
///
/// Householder reduction in panels: with A the matrix at the start of a panel and v_i, w_i = τ_i A_i v_i of its
/// reflectors, A_k = A + VWᵀ − WVᵀ (vᵀAv = 0 takes the quadratic term away that the symmetric reduction has). Half of
/// the work is one product of the trailing matrix with a vector a column, which is limited by memory bandwidth; the
/// other half is the rank-2 update of each panel.
class SkewTridiagonal {
 public:
  explicit SkewTridiagonal(Matrix z);

  Index size() const { return q_.size(); }
  const Vector& subdiagonal() const { return beta_; }  ///< β, n − 1
  const lapack::Reflectors& q() const { return q_; }

 private:
  lapack::Reflectors q_;
  Vector beta_;
};

}  // namespace gyromode::dense
