#pragma once

#include "gyromode/dense/spectrum.h"
#include "gyromode/structure/structure.h"

namespace gyromode::dense {

/// All roots of one component of a system, by the best dense solver for its class or the one asked for.
/// Throws MethodDoesNotApply; lapack::Failure where LAPACK does not converge; lapack::TooLarge.
Spectrum solve(const System& system, const Component& component, Method method = Method::automatic);

/// The same for a first-order system; `automatic`, `quadrature` and `general` apply.
Spectrum solve(const FirstOrderSystem& system, const Component& component, Method method = Method::automatic);

/// The matrix A restricted to rows and columns `order`.
Matrix restricted(const Matrix& a, const std::vector<Index>& rows, const std::vector<Index>& columns);

}  // namespace gyromode::dense
