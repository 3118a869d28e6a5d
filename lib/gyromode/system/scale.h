#pragma once

#include "gyromode/base/types.h"

#include <utility>

namespace gyromode {

/// Diagonal scalings d, all powers of two so that they add no rounding. D A D keeps inertia, definiteness and the roots
/// of a system scaled throughout; it takes the units of the coordinates (metres beside radians) out of every threshold.

/// d_i² ≈ 1/|a_ii|, and 1 where a_ii = 0. For positive definite A the diagonal of D A D lies in [½, 2].
Vector unit_diagonal_scale(const Matrix& a);

/// Brings the largest entry of every row of the Hermitian matrix D A D near 1 by a few sweeps of d_i /= √max_j |a_ij|
/// (Ruiz 2001); rows of zeros keep d_i = 1. For indefinite matrices, whose diagonal says little.
Vector equilibrating_scale(const Matrix& a);
Vector equilibrating_scale(const ComplexMatrix& a);

/// w with |a_ik| ≤ √(w_i w_k) up to a factor of two, near equality somewhere in every row; 0 for rows of zeros. For a
/// square matrix with |a_ik| = |a_ki|: how large an entry is in its own place. By Ruiz's sweeps.
Vector own_weights(const Matrix& a);
/// The same weights for the rows and the columns of a block b that couples two groups.
std::pair<Vector, Vector> own_weights_of_coupling(const Matrix& b);
/// √(w_i w_k) of these weights of rows and columns, and not less than |a_ik|: what rounding of a, by whoever made it,
/// is relative to.
Matrix entry_scale(const Matrix& a);

/// D A D.
Matrix scaled(const Matrix& a, const Vector& d);
ComplexMatrix scaled(const ComplexMatrix& a, const Vector& d);
/// Of a temporary, in its place.
Matrix scaled(Matrix&& a, const Vector& d);
ComplexMatrix scaled(ComplexMatrix&& a, const Vector& d);

/// The power of two nearest to x > 0; 1 for x = 0.
double power_of_two_near(double x);

/// Largest column sum of absolute values.
double norm1(const Matrix& a);
double norm1(const ComplexMatrix& a);

}  // namespace gyromode
