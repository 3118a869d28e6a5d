#include "gyromode/structure/ranked_factor.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode {

namespace {

class Elimination {
 public:
  Elimination(Matrix s, Matrix terms)
      : s_(std::move(s)), terms_(std::move(terms)), n_(s_.rows()), l_(Matrix::Zero(n_, n_)), order_(static_cast<std::size_t>(n_)) {
    std::iota(order_.begin(), order_.end(), Index{0});
    zero_ = zero_to_rounding(n_);
  }

  void run(RankedFactor& f) {
    Index at = 0;
    while (at < n_) {
      const Index width = choose(at);
      if (width == 0) break;
      const auto block = s_.block(at, at, width, width);
      const Vector d = small::symmetric_eigenvalues(block);
      for (const double x : d) ++(x < 0 ? f.negative : f.positive);
      f.smallest_kept = std::min(f.smallest_kept, d.cwiseAbs().minCoeff() / terms_.block(at, at, width, width).cwiseAbs().maxCoeff());
      eliminate(at, width);
      at += width;
    }
    rank_ = at;
    for (Index k = at; k < n_; ++k) {
      for (Index i = at; i < n_; ++i) f.largest_dropped = std::max(f.largest_dropped, ratio(i, k));
    }
    f.regular.assign(order_.begin(), order_.begin() + at);
    f.free.assign(order_.begin() + at, order_.end());
  }

  // N = P [−L₁₁⁻ᵀ L₂₁ᵀ; 1].
  Matrix null_space() const {
    const Index zero = n_ - rank_;
    Matrix n = Matrix::Zero(n_, zero);
    if (zero == 0) return n;
    Matrix top = -l_.block(rank_, 0, zero, rank_).transpose();
    l_.topLeftCorner(rank_, rank_).transpose().triangularView<Eigen::UnitUpper>().solveInPlace(top);
    for (Index i = 0; i < rank_; ++i) n.row(order_[static_cast<std::size_t>(i)]) = top.row(i);
    for (Index i = 0; i < zero; ++i) n(order_[static_cast<std::size_t>(rank_ + i)], i) = 1;
    return n;
  }

 private:
  double ratio(Index i, Index k) const { return s_(i, k) == 0 ? 0 : std::abs(s_(i, k)) / terms_(i, k); }

  // What is no more than rounding is no pivot. It stays where it is: to put zeros in its place would be an error of 8nε
  // in every entry, and the pivots that follow would be that.
  double size(Index i, Index k) const { return ratio(i, k) > zero_ ? std::abs(s_(i, k)) : 0; }

  void exchange(Index a, Index b) {
    if (a == b) return;
    for (Matrix* m : {&s_, &terms_}) {
      m->row(a).swap(m->row(b));
      m->col(a).swap(m->col(b));
    }
    l_.row(a).swap(l_.row(b));
    std::swap(order_[static_cast<std::size_t>(a)], order_[static_cast<std::size_t>(b)]);
  }

  // Brings the pivot to `at`; its width, or 0 where everything that is left is zero.
  Index choose(Index at) {
    constexpr double alpha = 0.6403882032022076;  // (1 + √17)/8
    Index diagonal = at, row = at, column = at;
    double on = 0, off = 0;
    for (Index k = at; k < n_; ++k) {
      if (size(k, k) > on) {
        on = size(k, k);
        diagonal = k;
      }
      for (Index i = k + 1; i < n_; ++i) {
        if (size(i, k) > off) {
          off = size(i, k);
          row = i;
          column = k;
        }
      }
    }
    if (on == 0 && off == 0) return 0;
    if (on >= alpha * off) {
      exchange(at, diagonal);
      return 1;
    }
    exchange(at, column);
    exchange(at + 1, row);
    return 2;
  }

  void eliminate(Index at, Index width) {
    const Index rest = n_ - at - width;
    const Matrix block = s_.block(at, at, width, width);
    const Matrix below = s_.block(at + width, at, rest, width);
    const Matrix factor = width == 1 ? Matrix(below / block(0, 0)) : Matrix(below * small::inverse(block));
    l_.block(at, at, width, width).setIdentity();
    l_.block(at + width, at, rest, width) = factor;
    s_.bottomRightCorner(rest, rest) -= factor * below.transpose();
    // the backward error is some ε of Σ |L||D||Lᵀ|
    terms_.bottomRightCorner(rest, rest) += factor.cwiseAbs() * below.cwiseAbs().transpose();
    for (Index k = at + width; k < n_; ++k) {
      for (Index i = k; i < n_; ++i) {
        s_(i, k) = s_(k, i) = 0.5 * (s_(i, k) + s_(k, i));
        terms_(i, k) = terms_(k, i) = std::max(terms_(i, k), terms_(k, i));
      }
    }
  }

  Matrix s_, terms_;
  Index n_;
  Matrix l_;
  std::vector<Index> order_;
  Index rank_ = 0;
  double zero_ = 0;
};

}  // namespace

bool RankedFactor::doubtful() const {
  const double n = static_cast<double>(regular.size() + free.size());
  const bool near_above = !(smallest_kept > 64 * n * epsilon), near_below = largest_dropped > 4 * n * epsilon;
  return near_above || near_below;
}

RankedFactor ranked_factor(const Matrix& k) { return ranked_factor(k, entry_scale(k)); }

RankedFactor ranked_factor(const Matrix& k, const Matrix& terms) {
  RankedFactor f;
  const Vector weights = own_weights(terms);
  Vector d(weights.size());
  for (Index i = 0; i < d.size(); ++i) d(i) = weights(i) > 0 ? power_of_two_near(1 / std::sqrt(weights(i))) : 1;
  Elimination elimination(scaled(k, d), scaled(terms, d));
  elimination.run(f);
  f.null_space = elimination.null_space();
  for (Index i = 0; i < f.zero(); ++i) f.null_space.col(i) = d.cwiseProduct(f.null_space.col(i)) / d(f.free[static_cast<std::size_t>(i)]);
  return f;
}

}  // namespace gyromode
