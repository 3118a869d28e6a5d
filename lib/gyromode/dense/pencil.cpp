#include "gyromode/dense/pencil.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/general.h"
#include "gyromode/lapack/small.h"

#include <cmath>

namespace gyromode::dense {

namespace {

// B = ±R with R > 0: R^{-½} A R^{-½} is Hermitian, its eigenvalues real.
std::vector<PencilRoot> definite_pencil(const ComplexMatrix& a, const lapack::HermitianEigen& b, double sign) {
  const ComplexMatrix root = b.vectors * b.values.cwiseAbs().cwiseSqrt().cwiseInverse().asDiagonal();
  const lapack::HermitianEigen e = small::hermitian_eigen(root.adjoint() * a * root);
  std::vector<PencilRoot> roots;
  for (Index k = 0; k < a.rows(); ++k) {
    const ComplexVector y = root * e.vectors.col(k);
    const double length = y.norm();
    roots.push_back({sign * e.values(k), y / length, sign / (length * length)});
  }
  return roots;
}

std::vector<PencilRoot> indefinite_pencil(const ComplexMatrix& a, const ComplexMatrix& b) {
  const Index n = a.rows();
  const ComplexMatrix standard = small::solve(b, a);
  if (!standard.allFinite()) return {};
  const auto e = lapack::general_eigen(standard);
  const ComplexVector values = conjugate_pairs(e.values);  // the roots of a self-adjoint pencil are real or in conjugate pairs
  std::vector<PencilRoot> roots;
  for (Index k = 0; k < n; ++k) {
    const ComplexVector y = e.vectors.col(k);
    // The vector of the mirrored root μ̄ is the left vector of μ: the partner is the column with the largest |y₋ᴴ B y|.
    const ComplexVector by = b * y;
    double partner = 0;
    for (Index i = 0; i < n; ++i) partner = std::max(partner, std::abs(e.vectors.col(i).dot(by)));
    const double own = std::real(y.dot(by));
    const bool on_axis = values(k).imag() == 0;
    roots.push_back({values(k), y, on_axis ? own : partner});
  }
  return roots;
}

}  // namespace

ComplexVector conjugate_pairs(const ComplexVector& computed) {
  ComplexVector values = computed;
  std::vector<bool> taken(static_cast<std::size_t>(values.size()), false);
  for (Index k = 0; k < values.size(); ++k) {
    if (taken[static_cast<std::size_t>(k)]) continue;
    Index partner = k;
    double nearest = 2 * std::abs(computed(k).imag());
    for (Index i = k + 1; i < values.size(); ++i) {
      const double distance = std::abs(computed(i) - std::conj(computed(k)));
      if (taken[static_cast<std::size_t>(i)] || !(distance < nearest)) continue;
      partner = i;
      nearest = distance;
    }
    taken[static_cast<std::size_t>(k)] = taken[static_cast<std::size_t>(partner)] = true;
    if (partner == k) {
      values(k) = computed(k).real();
    } else {
      values(k) = 0.5 * (computed(k) + std::conj(computed(partner)));
      values(partner) = std::conj(values(k));
    }
  }
  return values;
}

std::vector<PencilRoot> self_adjoint_pencil(const ComplexMatrix& a, const ComplexMatrix& b) {
  const lapack::HermitianEigen eb = small::hermitian_eigen(b);
  const Vector& beta = eb.values;
  constexpr double condition_limit = 1e7;
  const double weakest = beta.cwiseAbs().minCoeff();
  const double strongest = beta.cwiseAbs().maxCoeff();
  if (strongest <= condition_limit * weakest && weakest > 0) {
    if (beta.minCoeff() > 0) return definite_pencil(a, eb, 1);
    if (beta.maxCoeff() < 0) return definite_pencil(a, eb, -1);
  }
  if (!(weakest > zero_to_rounding(a.rows()) * strongest)) return {};
  return indefinite_pencil(a, b);
}

}  // namespace gyromode::dense
