#pragma once

#include "gyromode/dense/ignorable.h"
#include "gyromode/dense/spectrum.h"

namespace gyromode::dense {

/// The matrices of one component in the order of its Spectrum; with a partition, `split` coordinates in phase come first.
struct SecondOrder {
  Matrix mass, gyroscopic, stiffness;
  Index split = -1;

  Index size() const { return mass.rows(); }
};

/// Fills the roots, counts and path of `s`, whose order and split are set, by the solvers of theory §1 and §3. Zero roots of a singular K are
/// removed first and exactly.
void solve_second_order(const SecondOrder& m, Spectrum& s);

/// Error of null vectors of K: rounding over the gap to its other eigenvalues, and what the congruence to normal coordinates adds.
double null_error(Index n, double margin);

/// Zero modes and the counts that go with them, from the deflation of a singular K with the given null space (n × r, physical coordinates).
void store_zero_modes(const Deflation& d, const Matrix& null_space, Spectrum& s);

/// I q̇ + G q = 0 (theory §3d): singular values of L₁⁻¹BL₂⁻ᵀ with a partition, else of the bidiagonal half of the tridiagonalised L⁻¹GL⁻ᵀ. Singular
/// values up to 8 n ε of the largest (of ‖L⁻¹GL⁻ᵀ‖_F without a partition) are zero.
void solve_first_order(const Matrix& inertia, const Matrix& gyroscopic, Spectrum& s);

}  // namespace gyromode::dense
