#pragma once

#include "gyromode/dense/general/even_pencil.h"

namespace gyromode::dense {

/// The roots with Im λ > 0 of an even pencil from plain eigenpairs (λ, w), columns of w, all off the real axis: one of
/// each pair ±jω and quadruple.
///
/// A root and its partner −λ̄ have w₋ᴴ𝒮w ≠ 0, all others 0. Roots that pair with themselves are on the axis, and are
/// made so; close ones, and those whose pairing does not decide, are taken in groups, whose Hermitian pencil 𝓔 − ω(−j𝒮)
/// tells which are on the axis: its roots are real or in conjugate pairs. All products are made at once.
std::vector<EvenRoot> roots_of_groups(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w);

}  // namespace gyromode::dense
