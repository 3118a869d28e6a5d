#pragma once

#include "gyromode/dense/impedance.h"

#include <optional>

namespace gyromode::dense {

/// All roots and shapes of a small second-order component, each in its own scale (simultaneous_roots), whatever the
/// spread of its coefficients; zero roots, counts and null spaces as in `known`. n³ for every root: for small systems
/// that the solvers of one scale did not convince on. Nothing where the iteration does not settle.
std::optional<Spectrum> solve_in_own_scale(const Impedance& h, const Spectrum& known);

}  // namespace gyromode::dense
