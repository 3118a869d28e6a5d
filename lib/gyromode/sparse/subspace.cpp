#include "gyromode/sparse/subspace.h"

#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/orthonormal.h"

#include "gyromode/lapack/multiply.h"

#include <algorithm>
#include <cmath>

namespace gyromode::sparse {

Subspace::Subspace(const SparseSystem& system, const Groups& groups, const FreeMotions& free)
    : system_(system), free_(free), partition_(groups.partition) {
  for (int g = 0; g < 2; ++g) rows_[g] = groups.rows[static_cast<std::size_t>(g)];
  for (Index k = 0; k < free.nullity(); ++k) append(free.n.col(k), free.across[static_cast<std::size_t>(k)]);
  null_ = size_;
  k_.topLeftCorner(null_, null_).setZero();
  for (Index k = 0; k < null_; ++k) {
    if (!free.drifts[static_cast<std::size_t>(k)]) continue;
    g_.row(k).head(null_).setZero();
    g_.col(k).head(null_).setZero();
  }
}

void Subspace::reserve(Index columns) {
  if (columns <= v_.cols()) return;
  const Index more = std::max<Index>(2 * v_.cols(), columns);
  v_.conservativeResize(system_.size(), more);
  mv_.conservativeResize(system_.size(), more);
  k_.conservativeResize(more, more);
  g_.conservativeResize(more, more);
}

// Columns that are orthonormal to V and to each other.
void Subspace::append(const Matrix& fresh, bool across) {
  if (fresh.cols() == 0) return;
  const Index first = size_, m = fresh.cols();
  reserve(first + m);
  v_.middleCols(first, m) = fresh;
  mv_.middleCols(first, m) = symmetric_times(system_.mass(), fresh);
  size_ += m;
  const Matrix kx = symmetric_times(system_.stiffness(), fresh), gx = skew_times(system_.gyroscopic(), fresh);
  const Matrix k = lapack::multiply_tn(v_.leftCols(size_), kx), g = lapack::multiply_tn(v_.leftCols(size_), gx);
  k_.block(0, first, size_, m) = k;
  k_.block(0, first, null_, m).setZero();
  g_.block(0, first, size_, m) = g;
  k_.block(first, 0, m, first) = k_.block(0, first, first, m).transpose();
  g_.block(first, 0, m, first) = -g.topRows(first).transpose();
  k_.block(first, first, m, m) = 0.5 * (k.bottomRows(m) + k.bottomRows(m).transpose());
  g_.block(first, first, m, m) = 0.5 * (g.bottomRows(m) - g.bottomRows(m).transpose());
  column_across_.insert(column_across_.end(), static_cast<std::size_t>(m), across);
}

// Columns of size 1, twice against V and among themselves: what is left of one below 10⁻¹⁰ is rounding.
Matrix Subspace::add(const Matrix& x) {
  constexpr double least[2] = {1e-20, 1e-4};
  for (const bool across : {false, true}) {
    const std::vector<Index>& rows = rows_[across ? 1 : 0];
    if (rows.empty()) continue;
    Matrix part = Matrix::Zero(x.rows(), x.cols());
    if (partition_)
      part(rows, Eigen::all) = x(rows, Eigen::all);
    else
      part = x;
    const Vector squares = (part.cwiseProduct(symmetric_times(system_.mass(), part))).colwise().sum();
    std::vector<Index> there;
    for (Index j = 0; j < part.cols(); ++j) {
      if (squares(j) > 0) there.push_back(j);
    }
    if (there.empty()) continue;
    part = Matrix(part(Eigen::all, there));
    for (Index j = 0; j < part.cols(); ++j) part.col(j) /= std::sqrt(squares(there[static_cast<std::size_t>(j)]));
    for (const double square : least) {
      if (free_.t.cols() > 0) part -= free_.t * lapack::multiply_tn(free_.mt, part);
      if (size_ > 0) lapack::multiply_into(part, -1, v_.leftCols(size_), false, lapack::multiply_tn(mv_.leftCols(size_), part), false, 1);
      part = part * orthonormal_combinations(part.transpose() * symmetric_times(system_.mass(), part), square);
    }
    append(part, across);
    if (!partition_) break;
  }
  if (size_ == 0) return Matrix(0, x.cols());
  return lapack::multiply_tn(mv_.leftCols(size_), x);
}

// An orthonormal basis of every group's part of the combinations: what is below 10⁻⁷ of them is left.
void Subspace::keep(const Matrix& c) {
  constexpr double least = 1e-14;
  std::vector<Matrix> bases;
  Index kept = null_;
  for (const bool across : {false, true}) {
    Matrix part = c;
    part.topRows(null_).setZero();
    for (Index i = null_; i < size_; ++i) {
      if (column_across_[static_cast<std::size_t>(i)] != across) part.row(i).setZero();
    }
    for (Index j = 0; j < part.cols(); ++j) {
      const double size = part.col(j).norm();
      if (size > 0) part.col(j) /= size;
    }
    for (const double square : {least, 0.5}) part = part * orthonormal_combinations(part.transpose() * part, square);
    kept += part.cols();
    bases.push_back(std::move(part));
  }
  Matrix y(size_, kept);
  y << Matrix::Identity(size_, null_), bases[0], bases[1];
  const Matrix k = y.transpose() * stiffness() * y, g = y.transpose() * gyroscopic() * y;
  for (Matrix* a : {&v_, &mv_}) {
    constexpr Index rows = 4096;  // in pieces, so that no second basis is needed
    for (Index i = 0; i < a->rows(); i += rows) {
      const Index m = std::min(rows, a->rows() - i);
      const Matrix piece = lapack::multiply(a->block(i, 0, m, size_), y);
      a->block(i, 0, m, kept) = piece;
    }
  }
  size_ = kept;
  k_.topLeftCorner(size_, size_) = 0.5 * (k + k.transpose());
  k_.topRows(null_).setZero();
  k_.leftCols(null_).setZero();
  const Matrix still = g_.topLeftCorner(null_, null_);
  g_.topLeftCorner(size_, size_) = 0.5 * (g - g.transpose());
  g_.topLeftCorner(null_, null_) = still;
  column_across_.resize(static_cast<std::size_t>(null_));
  column_across_.insert(column_across_.end(), static_cast<std::size_t>(bases[0].cols()), false);
  column_across_.insert(column_across_.end(), static_cast<std::size_t>(bases[1].cols()), true);
}

}  // namespace gyromode::sparse
