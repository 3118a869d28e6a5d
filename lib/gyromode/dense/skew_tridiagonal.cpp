#include "gyromode/dense/skew_tridiagonal.h"

#include "gyromode/dense/skew_multiply.h"
#include "gyromode/lapack/multiply.h"

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

namespace {

constexpr Index panel_width = 48;

// Householder reflector 1 − τ v vᵀ with v(0) = 1 that maps x to β e₁ (LAPACK's dlarfg without the rescaling of tiny vectors: Z is scaled
// to order one by its caller, and a column below the underflow of its squares is zero to every backward error).
double reflector(Eigen::Ref<Vector> x, double& beta) {
  const double tail = x.size() > 1 ? x.tail(x.size() - 1).norm() : 0;
  if (tail == 0) {
    beta = x(0);
    return 0;
  }
  beta = -std::copysign(std::hypot(x(0), tail), x(0));
  const double tau = (beta - x(0)) / beta;
  x.tail(x.size() - 1) /= x(0) - beta;
  return tau;
}

// The trailing update A += V Wᵀ − W Vᵀ on the lower triangle, by block columns so that little of the upper one is touched.
void skew_rank_2k(MatrixSpan a, const MatrixView& v, const MatrixView& w) {
  const Index n = a.rows();
  const Index block = 128;
  for (Index j = 0; j < n; j += block) {
    const Index width = std::min(block, n - j);
    auto part = a.block(j, j, n - j, width);
    lapack::multiply_into(part, 1, v.bottomRows(n - j), false, w.middleRows(j, width), true, 1);
    lapack::multiply_into(part, -1, w.bottomRows(n - j), false, v.middleRows(j, width), true, 1);
  }
}

}  // namespace

SkewTridiagonal::SkewTridiagonal(Matrix z) : reflectors_(std::move(z)) {
  const Index n = reflectors_.rows();
  const Index columns = std::max<Index>(n - 1, 0);
  tau_ = Vector::Zero(columns);
  beta_ = Vector::Zero(columns);
  Matrix& a = reflectors_;
  SkewMultiply multiply(n);
  Matrix v(n, panel_width);
  Matrix w(n, panel_width);
  for (Index start = 0; start < columns; start += panel_width) {
    const Index width = std::min(panel_width, columns - start);
    v.setZero();
    w.setZero();
    for (Index i = 0; i < width; ++i) {
      const Index k = start + i;
      const Index below = n - k - 1;
      auto column = a.col(k).tail(below);
      lapack::multiply_add(column, 1, v.block(k + 1, 0, below, i), false, w.row(k).head(i).transpose());
      lapack::multiply_add(column, -1, w.block(k + 1, 0, below, i), false, v.row(k).head(i).transpose());
      tau_(k) = reflector(column, beta_(k));
      auto vk = v.col(i).tail(below);
      vk = column;
      vk(0) = 1;
      if (tau_(k) == 0) continue;
      auto wk = w.col(i).tail(below);
      multiply(a, k + 1, v.col(i).data() + k + 1, w.col(i).data() + k + 1);
      Vector wv = Vector::Zero(i);
      Vector vv = Vector::Zero(i);
      lapack::multiply_add(wv, 1, w.block(k + 1, 0, below, i), true, vk);
      lapack::multiply_add(vv, 1, v.block(k + 1, 0, below, i), true, vk);
      lapack::multiply_add(wk, 1, v.block(k + 1, 0, below, i), false, wv);
      lapack::multiply_add(wk, -1, w.block(k + 1, 0, below, i), false, vv);
      wk *= tau_(k);
    }
    const Index next = start + width;
    if (next < n) skew_rank_2k(a.block(next, next, n - next, n - next), v.block(next, 0, n - next, width), w.block(next, 0, n - next, width));
  }
}

void SkewTridiagonal::multiply_right(Matrix& x) const {
  const Index n = size();
  const Index columns = tau_.size();
  for (Index start = 0; start < columns; start += panel_width) {
    const Index width = std::min(panel_width, columns - start);
    const Index rows = n - start - 1;
    // The panel's product of reflectors as 1 − V T Vᵀ (Schreiber & Van Loan 1989).
    Matrix v = Matrix::Zero(rows, width);
    Matrix t = Matrix::Zero(width, width);
    for (Index i = 0; i < width; ++i) {
      v.col(i).tail(rows - i) = reflectors_.col(start + i).tail(rows - i);
      v(i, i) = 1;
      const double tau = tau_(start + i);
      t(i, i) = tau;
      if (i == 0) continue;
      const Vector overlap = v.leftCols(i).transpose() * v.col(i);
      t.col(i).head(i) = t.topLeftCorner(i, i).triangularView<Eigen::Upper>() * (-tau * overlap);
    }
    const Matrix xv = lapack::multiply(x.rightCols(rows), v);
    lapack::multiply_into(x.rightCols(rows), -1, lapack::multiply(xv, t), false, v, true, 1);
  }
}

}  // namespace gyromode::dense
