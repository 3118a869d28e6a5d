#include "gyromode/sparse/matrix.h"

#include <cmath>

namespace gyromode::sparse {

namespace {

// y += L x + sign Lᵀ x without the diagonal twice, all columns at once: x and y by rows, so that an entry meets its
// right-hand sides side by side.
Matrix times(const SparseMatrix& lower, const Matrix& x, double sign) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Rows in = x;
  Rows out = Rows::Zero(x.rows(), x.cols());
  for (Index j = 0; j < lower.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
      const Index i = it.row();
      out.row(i) += it.value() * in.row(j);
      if (i != j) out.row(j) += sign * it.value() * in.row(i);
    }
  }
  return out;
}

}  // namespace

Matrix symmetric_times(const SparseMatrix& lower, const Matrix& x) { return times(lower, x, 1); }
Matrix skew_times(const SparseMatrix& below, const Matrix& x) { return times(below, x, -1); }

double size_of(const SparseMatrix& lower, const Vector& moduli) {
  double sum = 0;
  for (Index j = 0; j < lower.outerSize(); ++j) {
    double column = 0;
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it) column += (it.row() == j ? 1 : 2) * std::abs(it.value()) * moduli(it.row());
    sum += column * moduli(j);
  }
  return sum;
}

double norm1(const SparseMatrix& lower) {
  Vector sums = Vector::Zero(lower.cols());
  for (Index j = 0; j < lower.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
      sums(j) += std::abs(it.value());
      if (it.row() != j) sums(it.row()) += std::abs(it.value());
    }
  }
  return sums.size() > 0 ? sums.maxCoeff() : 0;
}

SparseMatrix restricted(const SparseMatrix& lower, const std::vector<Index>& chosen) {
  std::vector<Index> place(static_cast<std::size_t>(lower.rows()), -1);
  for (std::size_t k = 0; k < chosen.size(); ++k) place[static_cast<std::size_t>(chosen[k])] = static_cast<Index>(k);
  std::vector<Eigen::Triplet<double>> entries;
  for (const Index j : chosen) {
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
      const Index i = place[static_cast<std::size_t>(it.row())];
      if (i >= 0) entries.emplace_back(static_cast<int>(i), static_cast<int>(place[static_cast<std::size_t>(j)]), it.value());
    }
  }
  SparseMatrix a(static_cast<Index>(chosen.size()), static_cast<Index>(chosen.size()));
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

}  // namespace gyromode::sparse
