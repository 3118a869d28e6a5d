#pragma once

#include "gyromode/dense/impedance.h"
#include "gyromode/structure/structure.h"

namespace gyromode::dense {

/// The impedance of one component in its natural units, in the order that the method works in: with a partition what is
/// in phase first. Throws NotApplicable.
Impedance impedance_of(const System& system, const Component& component, Method method);
Impedance impedance_of(const FirstOrderSystem& system, const Component& component, Method method);

/// All roots of that component, in the units of `h`. Throws NotConverged where LAPACK does not converge; TooLarge.
Spectrum solve(const Impedance& h, const Component& component, Method method);

/// All roots of one component of a system in the units given, by the best dense solver for its class or the one asked
/// for. Throws NotApplicable; NotConverged where LAPACK does not converge; TooLarge.
Spectrum solve(const System& system, const Component& component, Method method = Method::automatic);

/// The same for a first-order system; `automatic`, `quadrature` and `general` apply.
Spectrum solve(const FirstOrderSystem& system, const Component& component, Method method = Method::automatic);

/// The matrix A restricted to rows and columns `order`.
Matrix restricted(const Matrix& a, const std::vector<Index>& rows, const std::vector<Index>& columns);

}  // namespace gyromode::dense
