#pragma once

#include "gyromode/dense/ignorable.h"
#include "gyromode/spectrum/spectrum.h"

namespace gyromode::dense {

/// All roots of a system with singular K: ignorable coordinates are taken out (Deflation), the rest is solved as its
/// class allows. `null_space` (n × r) spans null(K). The counts of K in `s` are set already.
void solve_singular_stiffness(SingularSystem system, const Matrix& null_space, Spectrum& s);

/// Zero modes and the counts that go with them, from the deflation of a singular K with the given null space (n × r).
void store_zero_modes(const Deflation& d, const Matrix& null_space, Spectrum& s);

}  // namespace gyromode::dense
