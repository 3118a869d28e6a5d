#include "gyromode/sparse/matrix.h"

#include <algorithm>
#include <cmath>

namespace gyromode::sparse {

namespace {

// Columns that go through the matrix together, side by side in memory, so that an entry meets a cache line of each.
constexpr Index together = 8;

// y = (L + sign Lᵀ) x without the diagonal twice, of |L| where moduli are asked for.
template <bool moduli>
Matrix lower_times(const SparseMatrix& lower, const Matrix& x, double sign) {
  const Index n = x.rows();
  Matrix y(n, x.cols());
  std::vector<double> in(static_cast<std::size_t>(n * together)), out(in.size());
  for (Index first = 0; first < x.cols(); first += together) {
    const Index m = std::min(together, x.cols() - first);
    if (m < together) std::fill(in.begin(), in.end(), 0.0);
    if (first > 0) std::fill(out.begin(), out.end(), 0.0);
    for (Index c = 0; c < m; ++c) {
      for (Index i = 0; i < n; ++i) in[static_cast<std::size_t>(i * together + c)] = x(i, first + c);
    }
    const auto* rows = lower.innerIndexPtr();
    const double* values = lower.valuePtr();
    for (Index j = 0; j < n; ++j) {
      const double* xj = in.data() + j * together;
      double* yj = out.data() + j * together;
      double sum[together] = {};
      for (auto e = lower.outerIndexPtr()[j]; e < lower.outerIndexPtr()[j + 1]; ++e) {
        const Index i = rows[e];
        const double a = moduli ? std::abs(values[e]) : values[e], across = i == j ? 0.0 : sign * a;
        const double* xi = in.data() + i * together;
        double* yi = out.data() + i * together;
        for (Index c = 0; c < together; ++c) {
          yi[c] += a * xj[c];
          sum[c] += across * xi[c];
        }
      }
      for (Index c = 0; c < together; ++c) yj[c] += sum[c];
    }
    for (Index c = 0; c < m; ++c) {
      for (Index i = 0; i < n; ++i) y(i, first + c) = out[static_cast<std::size_t>(i * together + c)];
    }
  }
  return y;
}

}  // namespace

Matrix parts_of(const ComplexVector& z) {
  Matrix parts(z.size(), 2);
  parts << z.real(), z.imag();
  return parts;
}

Matrix symmetric_times(const SparseMatrix& lower, const Matrix& x) { return lower_times<false>(lower, x, 1); }
Matrix skew_times(const SparseMatrix& below, const Matrix& x) { return lower_times<false>(below, x, -1); }

Vector sizes_of(const SparseMatrix& lower, const Matrix& moduli) {
  return moduli.cwiseProduct(lower_times<true>(lower, moduli, 1)).colwise().sum();
}

Matrix full(const SparseMatrix& lower, double sign) {
  const Matrix below = lower;
  Matrix all = below + sign * below.transpose();
  if (sign > 0) all.diagonal() = below.diagonal();
  return all;
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
  SparseMatrix a(static_cast<Index>(chosen.size()), static_cast<Index>(chosen.size()));
  if (chosen.empty()) return a;
  std::vector<int> sizes;
  for (const Index j : chosen) {
    int size = 0;
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it) size += place[static_cast<std::size_t>(it.row())] >= 0 ? 1 : 0;
    sizes.push_back(size);
  }
  a.reserve(sizes);
  Index column = 0;
  for (const Index j : chosen) {
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
      const Index i = place[static_cast<std::size_t>(it.row())];
      if (i >= 0) a.insert(i, column) = it.value();
    }
    ++column;
  }
  a.makeCompressed();
  return a;
}

Matrix times(const SparseMatrix& b, const Matrix& x) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, together, Eigen::RowMajor>;
  Matrix y(b.rows(), x.cols());
  for (Index first = 0; first < x.cols(); first += together) {
    const Index m = std::min(together, x.cols() - first);
    Rows in = Rows::Zero(x.rows(), together), out = Rows::Zero(b.rows(), together);
    in.leftCols(m) = x.middleCols(first, m);
    for (Index j = 0; j < b.cols(); ++j) {
      const double* from = in.data() + j * together;
      for (SparseMatrix::InnerIterator it(b, j); it; ++it) {
        double* to = out.data() + it.row() * together;
        for (Index c = 0; c < together; ++c) to[c] += it.value() * from[c];
      }
    }
    y.middleCols(first, m) = out.leftCols(m);
  }
  return y;
}

Matrix transposed_times(const SparseMatrix& b, const Matrix& x) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, together, Eigen::RowMajor>;
  Matrix y(b.cols(), x.cols());
  for (Index first = 0; first < x.cols(); first += together) {
    const Index m = std::min(together, x.cols() - first);
    Rows in = Rows::Zero(x.rows(), together), out(b.cols(), together);
    in.leftCols(m) = x.middleCols(first, m);
    for (Index j = 0; j < b.cols(); ++j) {
      double sum[together] = {};
      for (SparseMatrix::InnerIterator it(b, j); it; ++it) {
        const double* from = in.data() + it.row() * together;
        for (Index c = 0; c < together; ++c) sum[c] += it.value() * from[c];
      }
      std::copy(sum, sum + together, out.data() + j * together);
    }
    y.middleCols(first, m) = out.leftCols(m);
  }
  return y;
}

SparseMatrix block_of(const SparseMatrix& lower, const std::vector<Index>& rows, const std::vector<Index>& columns) {
  std::vector<Index> row(static_cast<std::size_t>(lower.rows()), -1), column = row;
  for (std::size_t k = 0; k < rows.size(); ++k) row[static_cast<std::size_t>(rows[k])] = static_cast<Index>(k);
  for (std::size_t k = 0; k < columns.size(); ++k) column[static_cast<std::size_t>(columns[k])] = static_cast<Index>(k);
  std::vector<Eigen::Triplet<double>> entries;
  const auto put = [&](Index i, Index j, double value) {
    const Index r = row[static_cast<std::size_t>(i)], c = column[static_cast<std::size_t>(j)];
    if (r >= 0 && c >= 0) entries.emplace_back(static_cast<int>(r), static_cast<int>(c), value);
  };
  for (Index j = 0; j < lower.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
      put(it.row(), j, it.value());
      if (it.row() != j) put(j, it.row(), it.value());
    }
  }
  SparseMatrix b(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  b.setFromTriplets(entries.begin(), entries.end());
  return b;
}

}  // namespace gyromode::sparse
