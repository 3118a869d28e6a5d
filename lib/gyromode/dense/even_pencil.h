#pragma once

#include "gyromode/lapack/general.h"
#include "gyromode/lapack/types.h"

#include <vector>

namespace gyromode::dense {

/// 𝒮 ẇ = −𝓔 w of even order, real, 𝒮 skew and 𝓔 symmetric (theory §3c).
struct EvenPencil {
  Matrix s, e;
};

/// A root with Re λ = 0 exactly (on the axis, ω = Im λ > 0), or Re λ > 0 and Im λ ≥ 0: one of each pair or quadruple.
struct EvenRoot {
  Complex lambda;
  ComplexVector w;
};

/// Eigenpairs of −𝒮⁻¹𝓔, its structure not looked at.
lapack::GeneralEigen plain_eigen(const EvenPencil& p);

/// The pencil in the real basis V of an invariant subspace, orthonormal columns.
EvenPencil projected(const EvenPencil& p, const Matrix& v);

/// All roots from the plain eigenpairs (λ, w): groups that can meet on the axis by projection on the Hermitian pencil 𝓔 − ω(−j𝒮), roots far below the largest
/// projected out and solved by themselves.
std::vector<EvenRoot> roots_of(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w);

}  // namespace gyromode::dense
