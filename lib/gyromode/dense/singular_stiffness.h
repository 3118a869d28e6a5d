#pragma once

#include "gyromode/dense/ignorable.h"
#include "gyromode/dense/mass_normal.h"
#include "gyromode/dense/spectrum.h"

namespace gyromode::dense {

/// All roots of a system with singular K: ignorable coordinates are taken out (Deflation), the rest is solved as its class allows. `null_space`
/// (n × r, physical coordinates) spans null(K); with a partition its first `null_in_first` columns lie in the first group. The counts of K in
/// `s` are set already.
void solve_singular_stiffness(NormalForm form, const MassNormalGroups& normal, const Matrix& null_space, Index null_in_first, Spectrum& s);

/// Error of null vectors of K: rounding over the gap to its other eigenvalues, and what the congruence to normal coordinates adds.
double null_error(Index n, double margin);

/// Zero modes and the counts that go with them, from the deflation of a singular K with the given null space (n × r, physical coordinates).
void store_zero_modes(const Deflation& d, const Matrix& null_space, Spectrum& s);

}  // namespace gyromode::dense
