#pragma once

#include "gyromode/lapack/general.h"
#include "gyromode/base/types.h"

#include <vector>

namespace gyromode::dense {

/// 𝒮 ẇ = −𝓔 w of even order, real, 𝒮 skew and 𝓔 symmetric (theory §3c): either of z̈ + Γż + kz = 0, w = (z, ż), 𝒮 = [Γ
/// 1; −1 0], 𝓔 = diag(k, 1), of which only Γ and k are stored, or any.
class EvenPencil {
 public:
  static EvenPencil of_second_order(Matrix gamma, Matrix k);
  EvenPencil(Matrix s, Matrix e) : s_(std::move(s)), e_(std::move(e)) {}

  Index size() const { return second_order_ ? 2 * s_.rows() : s_.rows(); }
  /// 𝒮W and 𝓔W.
  Matrix s_times(const Matrix& w) const;
  Matrix e_times(const Matrix& w) const;
  /// Eigenpairs of −𝒮⁻¹𝓔, the structure not looked at; of a second-order pencil those of [0 1; −k −Γ].
  lapack::GeneralEigen plain_eigen() const;
  /// The pencil in the real basis V of an invariant subspace, orthonormal columns.
  EvenPencil projected(const Matrix& v) const;

 private:
  Matrix s_, e_;  // Γ and k of a second-order pencil
  bool second_order_ = false;
};

/// A root with Re λ = 0 exactly (on the axis, ω = Im λ > 0), or Re λ > 0 and Im λ ≥ 0: one of each pair or quadruple.
struct EvenRoot {
  Complex lambda;
  ComplexVector w;
  ComplexVector left;  ///< off the axis: the vector of −λ̄
};

/// All roots from the plain eigenpairs (λ, w): groups that can meet on the axis by projection on the Hermitian pencil 𝓔
/// − ω(−j𝒮), roots far below the largest projected out and solved by themselves.
std::vector<EvenRoot> roots_of(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w);

}  // namespace gyromode::dense
