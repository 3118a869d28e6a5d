#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode::dense {

/// One root of A y = μ B y with A and B self-adjoint: the small problem that is left when a group of close roots is
/// projected.
struct PencilRoot {
  Complex value;    ///< μ; its imaginary part is exactly 0 for a root on the real axis
  ComplexVector y;  ///< 2-norm 1
  double form = 0;  ///< yᴴBy for real μ; |y₋ᴴB y| with y₋ the vector of μ̄ for a complex μ
};

/// All roots of the c × c pencil. Where B is definite (its eigenvalues of one sign, condition below 1e7) all are real
/// by construction and the vectors B-orthogonal, however close the roots are. Otherwise the eigenvalues of B⁻¹A, the
/// imaginary parts kept. Empty where B is singular to rounding: the group is defective, and nothing can be said from
/// it.
std::vector<PencilRoot> self_adjoint_pencil(const ComplexMatrix& a, const ComplexMatrix& b);

/// Values of which rounding has spoilt that they are real or in conjugate pairs: each is matched with the nearest
/// conjugate of another one; where that is nearer than its own, the two are made a pair, else it is made real.
ComplexVector conjugate_pairs(const ComplexVector& computed);

}  // namespace gyromode::dense
