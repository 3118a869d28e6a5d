#include "gyromode/lapack/small.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>

namespace gyromode::small {

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

Matrix orthonormal_columns(const Matrix& a) {
  return Eigen::HouseholderQR<Matrix>(a).householderQ() * Matrix::Identity(a.rows(), a.cols());
}
ComplexMatrix orthonormal_columns(const ComplexMatrix& a) {
  return Eigen::HouseholderQR<ComplexMatrix>(a).householderQ() * ComplexMatrix::Identity(a.rows(), a.cols());
}
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

}  // namespace gyromode::small
