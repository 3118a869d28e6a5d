#include "gyromode/structure/ranked_skew.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/system/laws.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode {

namespace {

struct Pivot {
  Index i = 0, k = 0;
  double size = 0;
};

// What is no more than `zero` of its terms is no pivot, and stays where it is (see ranked_factor.cpp).
Pivot largest(const Matrix& s, const Matrix& terms, double zero, Index from) {
  Pivot p;
  for (Index k = from; k < s.cols(); ++k) {
    for (Index i = k + 1; i < s.rows(); ++i) {
      if (std::abs(s(i, k)) > p.size && std::abs(s(i, k)) > zero * terms(i, k)) p = {i, k, std::abs(s(i, k))};
    }
  }
  return p;
}

}  // namespace

// With the pair first, S = [g J, −Bᵀ; B, S₂], J = [0 −1; 1 0]: the Schur complement is S₂ + B(gJ)⁻¹Bᵀ = S₂ + (b₁b₂ᵀ −
// b₂b₁ᵀ)/g, and null vectors (t, z) have t = (gJ)⁻¹Bᵀz = (b₂ᵀz, −b₁ᵀz)/g.
RankedSkew ranked_skew(Matrix s, Matrix terms) {
  const Index n = s.rows();
  const double zero = zero_to_rounding(n);
  std::vector<Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), Index{0});
  RankedSkew f;
  Matrix t = Matrix::Zero(n, n);  // rows of pivots: what they are in a null vector
  const auto exchange = [&](Index a, Index b) {
    if (a == b) return;
    for (Matrix* m : {&s, &terms}) {
      m->row(a).swap(m->row(b));
      m->col(a).swap(m->col(b));
    }
    t.col(a).swap(t.col(b));
    std::swap(order[static_cast<std::size_t>(a)], order[static_cast<std::size_t>(b)]);
  };
  Index at = 0;
  for (; at + 1 < n; at += 2) {
    const Pivot p = largest(s, terms, zero, at);
    if (p.size == 0) break;
    exchange(at, p.k);
    exchange(at + 1, p.i);  // p.i > p.k ≥ at
    const double g = s(at + 1, at);
    f.smallest_kept = std::min(f.smallest_kept, std::abs(g) / terms(at + 1, at));
    const Index rest = n - at - 2;
    const Vector b1 = s.col(at).tail(rest), b2 = s.col(at + 1).tail(rest);
    t.row(at).tail(rest) = b2.transpose() / g;
    t.row(at + 1).tail(rest) = -b1.transpose() / g;
    s.bottomRightCorner(rest, rest) += (b1 * b2.transpose() - b2 * b1.transpose()) / g;
    terms.bottomRightCorner(rest, rest) +=
        (b1.cwiseAbs() * b2.cwiseAbs().transpose() + b2.cwiseAbs() * b1.cwiseAbs().transpose()) / std::abs(g);
  }
  f.regular.assign(order.begin(), order.begin() + at);
  f.free.assign(order.begin() + at, order.end());
  const Index free = n - at;
  Matrix all = Matrix::Zero(n, free);  // in the order of elimination
  all.bottomRows(free).setIdentity();
  for (Index i = at - 1; i >= 0; --i)
    all.row(i) = t.row(i).tail(n - i - (i % 2 == 0 ? 2 : 1)) * all.bottomRows(n - i - (i % 2 == 0 ? 2 : 1));
  f.null_space = Matrix::Zero(n, free);
  for (Index i = 0; i < n; ++i) f.null_space.row(order[static_cast<std::size_t>(i)]) = all.row(i);
  return f;
}

RankedSkew ranked_skew_on(const Matrix& g, const Matrix& columns) {
  const auto congruence = [](const Matrix& c, const Matrix& a) { return lapack::multiply_tn(c, lapack::multiply(a, c)); };
  return ranked_skew(skew_part(congruence(columns, g)), congruence(columns.cwiseAbs(), entry_scale(g)));
}

}  // namespace gyromode
