#pragma once

#include "gyromode/lapack/hermitian.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/base/types.h"

#include <vector>

/// Decompositions by Eigen of small matrices, some tens of rows, where a call of LAPACK costs more than the work, and
/// of those for which full pivoting or one-sided Jacobi is wanted. They are templates that take the compiler seconds
/// each: only small*.cpp include them.
namespace gyromode::small {

/// A = V diag(values) Vᴴ of a Hermitian matrix (n × n, lower triangle read), values ascending.
lapack::SymmetricEigen symmetric_eigen(const Matrix& a);
lapack::HermitianEigen hermitian_eigen(const ComplexMatrix& a);
Vector symmetric_eigenvalues(const Matrix& a);
Vector hermitian_eigenvalues(const ComplexMatrix& a);

/// A V = B V diag(values), VᵀBV = 1, B positive definite (n × n, lower triangles read), values ascending.
lapack::SymmetricEigen symmetric_definite_eigen(const Matrix& a, const Matrix& b);

/// A = Q T Qᴴ, T real symmetric tridiagonal, Q unitary, of a Hermitian matrix (Householder).
struct Tridiagonal {
  ComplexMatrix q;
  Vector diagonal, subdiagonal;
};
Tridiagonal tridiagonalised(const ComplexMatrix& a);

/// Singular values, descending, by one-sided Jacobi: small ones to full relative accuracy where scaling is what makes
/// them small.
Vector singular_values(const ComplexMatrix& a);
/// A = U diag(values) Vᴴ with U m × m and V n × n unitary, by the same.
struct Svd {
  Vector values;
  ComplexMatrix u, v;
};
Svd singular_value_decomposition(const ComplexMatrix& a);
/// Values and V (n × min(m, n)) only, by divide and conquer: for tall matrices of up to some hundred columns. u is left
/// empty.
Svd right_singular(const ComplexMatrix& a);

/// A = QR, Q m × min(m, n) with orthonormal columns, R upper triangular or trapezoidal (Householder).
struct Qr {
  ComplexMatrix q, r;
};
Qr qr(const ComplexMatrix& a);
Matrix orthonormal_columns(const Matrix& a);
ComplexMatrix orthonormal_columns(const ComplexMatrix& a);
/// The whole m × m orthogonal factor.
Matrix orthogonal_factor(const Matrix& a);

/// A P = QR with the largest remaining column first. Pivots up to `threshold` of the largest are zero: rank; Q, m ×
/// rank, spans the columns of A.
struct RankedQr {
  Index rank = 0;
  Matrix q;
};
RankedQr ranked_qr(const Matrix& a, double threshold);
/// The order in which columns are taken.
std::vector<Index> largest_columns_first(const ComplexMatrix& a);

/// A⁻¹b, A n × n, b n × m. Not finite where A is singular to the last bit.
Matrix solve(const Matrix& a, const Matrix& b);
ComplexMatrix solve(const ComplexMatrix& a, const ComplexMatrix& b);
Matrix inverse(const Matrix& a);
/// The same with full pivoting: the minor solution where A is singular.
Matrix solve_fully_pivoted(const Matrix& a, const Matrix& b);
ComplexMatrix solve_fully_pivoted(const ComplexMatrix& a, const ComplexMatrix& b);
/// An estimate of 1/(‖A‖₁‖A⁻¹‖₁).
double reciprocal_condition(const Matrix& a);
/// The pivots of full pivoting, largest first, and the sign of the permutations: det A is their product.
struct Pivots {
  ComplexVector values;
  int sign = 1;
};
Pivots pivots(const ComplexMatrix& a);

/// A = U T Uᴴ, T upper triangular.
struct Schur {
  ComplexMatrix u, t;
};
Schur schur(const ComplexMatrix& a);
/// Eigenvalues of a real matrix, conjugate pairs side by side.
ComplexVector eigenvalues(const Matrix& a);
/// e^A by scaling and squaring (Higham 2005).
Matrix exponential(const Matrix& a);

}  // namespace gyromode::small
