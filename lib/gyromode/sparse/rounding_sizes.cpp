#include "gyromode/sparse/rounding_sizes.h"

#include "gyromode/base/rounding.h"

#include <algorithm>
#include <cmath>

namespace gyromode::sparse {

namespace {

double largest_row(const SparseMatrix& lower, const Vector& diagonal) {
  const Vector root = diagonal.cwiseSqrt().cwiseInverse();
  Vector sum = Vector::Zero(lower.cols());
  for (Index j = 0; j < lower.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
      const double a = std::abs(it.value()) * root(it.row()) * root(j);
      sum(j) += a;
      if (it.row() != j) sum(it.row()) += a;
    }
  }
  return sum.size() > 0 ? sum.maxCoeff() : 0;
}

}  // namespace

// A diagonal of K that is none, of a motion that nothing holds, counts as a little.
RoundingSizes::RoundingSizes(const SparseSystem& s) : k_(s.stiffness().diagonal().cwiseAbs()), m_(s.mass().diagonal()) {
  constexpr double little = 1e-8;
  k_ = k_.cwiseMax(little * k_.maxCoeff()).cwiseMax(1e-300);
  ck_ = largest_row(s.stiffness(), k_);
  cg_ = largest_row(s.gyroscopic(), m_);
  cm_ = largest_row(s.mass(), m_);
}

double RoundingSizes::of(const ComplexVector& x, double w) const {
  constexpr double rounding = 4 * epsilon;
  const Vector square = x.cwiseAbs2();
  return rounding * (ck_ * k_.dot(square) + (w * cg_ + w * w * cm_) * m_.dot(square));
}

}  // namespace gyromode::sparse
