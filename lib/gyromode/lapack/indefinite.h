#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode::lapack {

/// A = P L D Lᴴ Pᵀ with D of 1 × 1 and 2 × 2 blocks (Bunch–Kaufman, lower triangle): dsytrf, zhetrf.
template <class Scalar>
struct IndefiniteFactor {
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> factor;  ///< L and D in the first n columns of n rows
  std::vector<int> pivots;                                       ///< LAPACK's ipiv: two equal negative numbers mark a 2 × 2 block
};

IndefiniteFactor<double> factor_indefinite(Matrix a);
IndefiniteFactor<Complex> factor_indefinite(ComplexMatrix a);

/// A⁻¹ b, b n × m. A block of D that is exactly zero makes the result infinite: the caller tests it.
Matrix solve(const IndefiniteFactor<double>& f, Matrix b);
ComplexMatrix solve(const IndefiniteFactor<Complex>& f, ComplexMatrix b);

/// Reciprocal condition number (1-norm) of A whose 1-norm is `norm` (dsycon, zhecon).
double reciprocal_condition(const IndefiniteFactor<double>& f, double norm);
double reciprocal_condition(const IndefiniteFactor<Complex>& f, double norm);

/// Eigenvalues of D, one per row of A; by Sylvester their signs are the inertia of A.
template <class Scalar>
Vector pivot_values(const IndefiniteFactor<Scalar>& f);
extern template Vector pivot_values(const IndefiniteFactor<double>&);
extern template Vector pivot_values(const IndefiniteFactor<Complex>&);

}  // namespace gyromode::lapack
