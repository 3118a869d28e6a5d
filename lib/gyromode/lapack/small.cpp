#include "gyromode/lapack/small.h"

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

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
Vector hermitian_eigenvalues(const ComplexMatrix& a) { return Eigen::SelfAdjointEigenSolver<ComplexMatrix>(a, Eigen::EigenvaluesOnly).eigenvalues(); }

lapack::SymmetricEigen symmetric_definite_eigen(const Matrix& a, const Matrix& b) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> e(a, b);
  return {e.eigenvalues(), e.eigenvectors()};
}

Tridiagonal tridiagonalised(const ComplexMatrix& a) {
  const Eigen::Tridiagonalization<ComplexMatrix> t(a);
  return {t.matrixQ(), t.diagonal(), t.subDiagonal()};
}

Vector singular_values(const ComplexMatrix& a) { return Eigen::JacobiSVD<ComplexMatrix>(a).singularValues(); }

Svd singular_value_decomposition(const ComplexMatrix& a) {
  const Eigen::JacobiSVD<ComplexMatrix> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.singularValues(), svd.matrixU(), svd.matrixV()};
}

Svd right_singular(const ComplexMatrix& a) {
  const Eigen::BDCSVD<ComplexMatrix> svd(a, Eigen::ComputeThinV);
  return {svd.singularValues(), {}, svd.matrixV()};
}

Qr qr(const ComplexMatrix& a) {
  const Eigen::HouseholderQR<ComplexMatrix> f(a);
  const Index least = std::min(a.rows(), a.cols());
  return {f.householderQ() * ComplexMatrix::Identity(a.rows(), least), f.matrixQR().topRows(least).triangularView<Eigen::Upper>()};
}

Matrix orthonormal_columns(const Matrix& a) { return Eigen::HouseholderQR<Matrix>(a).householderQ() * Matrix::Identity(a.rows(), a.cols()); }
ComplexMatrix orthonormal_columns(const ComplexMatrix& a) { return Eigen::HouseholderQR<ComplexMatrix>(a).householderQ() * ComplexMatrix::Identity(a.rows(), a.cols()); }
Matrix orthogonal_factor(const Matrix& a) { return Eigen::HouseholderQR<Matrix>(a).householderQ(); }

RankedQr ranked_qr(const Matrix& a, double threshold) {
  Eigen::ColPivHouseholderQR<Matrix> f(a);
  f.setThreshold(threshold);
  return {f.rank(), f.householderQ() * Matrix::Identity(a.rows(), f.rank())};
}

std::vector<Index> largest_columns_first(const ComplexMatrix& a) {
  const auto order = Eigen::ColPivHouseholderQR<ComplexMatrix>(a).colsPermutation().indices().eval();
  return {order.begin(), order.end()};
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

Schur schur(const ComplexMatrix& a) {
  const Eigen::ComplexSchur<ComplexMatrix> f(a);
  return {f.matrixU(), f.matrixT()};
}

ComplexVector eigenvalues(const Matrix& a) { return Eigen::EigenSolver<Matrix>(a, false).eigenvalues(); }
Matrix exponential(const Matrix& a) { return a.exp(); }

}  // namespace gyromode::small
