#include "gyromode/lapack/small.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace gyromode::small {

lapack::SymmetricEigen symmetric_eigen(const Matrix& a) {
  const Eigen::SelfAdjointEigenSolver<Matrix> e(a);
  return {e.eigenvalues(), e.eigenvectors()};
}

lapack::HermitianEigen hermitian_eigen(const ComplexMatrix& a) {
  const Eigen::SelfAdjointEigenSolver<ComplexMatrix> e(a);
  return {e.eigenvalues(), e.eigenvectors()};
}

Vector symmetric_eigenvalues(const Matrix& a) { return Eigen::SelfAdjointEigenSolver<Matrix>(a, Eigen::EigenvaluesOnly).eigenvalues(); }
Vector hermitian_eigenvalues(const ComplexMatrix& a) {
  return Eigen::SelfAdjointEigenSolver<ComplexMatrix>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

lapack::SymmetricEigen symmetric_definite_eigen(const Matrix& a, const Matrix& b) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> e(a, b);
  return {e.eigenvalues(), e.eigenvectors()};
}

Tridiagonal tridiagonalised(const ComplexMatrix& a) {
  const Eigen::Tridiagonalization<ComplexMatrix> t(a);
  return {t.matrixQ(), t.diagonal(), t.subDiagonal()};
}

Matrix solve(const Matrix& a, const Matrix& b) { return a.partialPivLu().solve(b); }
ComplexMatrix solve(const ComplexMatrix& a, const ComplexMatrix& b) { return a.partialPivLu().solve(b); }
Matrix inverse(const Matrix& a) { return a.inverse(); }
Matrix solve_fully_pivoted(const Matrix& a, const Matrix& b) { return a.fullPivLu().solve(b); }
ComplexMatrix solve_fully_pivoted(const ComplexMatrix& a, const ComplexMatrix& b) { return a.fullPivLu().solve(b); }
double reciprocal_condition(const Matrix& a) { return a.fullPivLu().rcond(); }

Pivots pivots(const ComplexMatrix& a) {
  const Eigen::FullPivLU<ComplexMatrix> f(a);
  return {f.matrixLU().diagonal(), static_cast<int>(f.permutationP().determinant() * f.permutationQ().determinant())};
}

}  // namespace gyromode::small
