#include "gyromode/dense/general/skew_tridiagonal.h"

#include "gyromode/dense/general/skew_multiply.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/team.h"

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

namespace {

constexpr Index panel_width = 32;

// Householder reflector 1 − τ v vᵀ with v(0) = 1 that maps x to β e₁ (LAPACK's dlarfg without the rescaling of tiny
// vectors: Z is scaled to order one by its caller, and a column below the underflow of its squares is zero to every
// backward error).
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

// The panel's v_i and w_i, in turn: columns 2i and 2i + 1. Rows belong to those of Z.
class Panel {
 public:
  explicit Panel(Index n) : pairs_(n, 2 * panel_width), swapped_(n, 2 * panel_width), coefficients_(2 * panel_width) {}

  auto v(Index i) { return pairs_.col(2 * i); }
  auto w(Index i) { return pairs_.col(2 * i + 1); }

  // column(k + 1 …) += Σ v_i w_i(k) − w_i v_i(k) over the first `count` pairs.
  void update_column(Eigen::Ref<Vector> column, Index k, Index count) {
    for (Index i = 0; i < count; ++i) {
      coefficients_(2 * i) = pairs_(k, 2 * i + 1);
      coefficients_(2 * i + 1) = -pairs_(k, 2 * i);
    }
    lapack::multiply_add(column, 1, below(k, count), false, coefficients_.head(2 * count));
  }

  // y += Σ v_i (w_iᵀx) − w_i (v_iᵀx), rows k + 1 ….
  void add_product(Eigen::Ref<Vector> y, const Eigen::Ref<const Vector>& x, Index k, Index count) {
    Vector overlap = Vector::Zero(2 * count);
    lapack::multiply_add(overlap, 1, below(k, count), true, x);
    for (Index i = 0; i < count; ++i) {
      coefficients_(2 * i) = overlap(2 * i + 1);
      coefficients_(2 * i + 1) = -overlap(2 * i);
    }
    lapack::multiply_add(y, 1, below(k, count), false, coefficients_.head(2 * count));
  }

  // A += V Wᵀ − W Vᵀ on the lower triangle of the rows from `first` on, by block columns so that little of the upper
  // one is touched.
  void update_trailing(lapack::Team& team, Matrix& a, Index first, Index count) {
    constexpr Index block = 128;
    for (Index i = 0; i < count; ++i) {
      swapped_.col(2 * i) = pairs_.col(2 * i + 1);
      swapped_.col(2 * i + 1) = -pairs_.col(2 * i);
    }
    const Index n = a.rows() - first;
    team.run([&](int part) {
      const Index end = equal_area(n, part + 1, team.size());
      for (Index j = equal_area(n, part, team.size()); j < end; j += block) {
        const Index width = std::min(block, end - j);
        const auto rows = pairs_.bottomRows(n - j).leftCols(2 * count);
        const auto columns = swapped_.middleRows(first + j, width).leftCols(2 * count);
        lapack::multiply_into(a.block(first + j, first + j, n - j, width), 1, rows, false, columns, true, 1);
      }
    });
  }

 private:
  Eigen::Block<Matrix> below(Index k, Index count) { return pairs_.block(k + 1, 0, pairs_.rows() - k - 1, 2 * count); }

  Matrix pairs_, swapped_;
  Vector coefficients_;
};

}  // namespace

SkewTridiagonal::SkewTridiagonal(Matrix z) {
  const Index n = z.rows();
  const Index columns = std::max<Index>(n - 1, 0);
  q_ = {std::move(z), Vector::Zero(columns), 1};
  beta_ = Vector::Zero(columns);
  Matrix& a = q_.vectors;
  lapack::Team team(lapack::threads_for(n));
  SkewMultiply multiply(team, n);
  Panel panel(n);
  for (Index start = 0; start < columns; start += panel_width) {
    const Index width = std::min(panel_width, columns - start);
    for (Index i = 0; i < width; ++i) {
      const Index k = start + i;
      const Index below = n - k - 1;
      auto column = a.col(k).tail(below);
      panel.update_column(column, k, i);
      q_.tau(k) = reflector(column, beta_(k));
      panel.v(i).head(k + 1).setZero();
      panel.w(i).setZero();
      auto v = panel.v(i).tail(below);
      v = column;
      v(0) = 1;
      if (q_.tau(k) == 0) continue;
      auto w = panel.w(i).tail(below);
      multiply(a, k + 1, v.data(), w.data());
      panel.add_product(w, v, k, i);
      w *= q_.tau(k);
    }
    panel.update_trailing(team, a, start + width, width);
  }
}

}  // namespace gyromode::dense
