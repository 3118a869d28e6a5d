#include "gyromode/certificate/assess_unstable.h"

#include "gyromode/lapack/multiply.h"

#include <Eigen/SVD>

#include <cmath>
#include <limits>

namespace gyromode {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

ComplexMatrix times(const Matrix& a, const ComplexMatrix& x) {
  ComplexMatrix y(a.rows(), x.cols());
  y.real() = lapack::multiply(a, x.real());
  y.imag() = lapack::multiply(a, x.imag());
  return y;
}

ComplexMatrix times_transposed(const Matrix& a, const ComplexMatrix& x) {
  ComplexMatrix y(a.cols(), x.cols());
  y.real() = lapack::multiply_tn(a, x.real());
  y.imag() = lapack::multiply_tn(a, x.imag());
  return y;
}

}  // namespace

CharacteristicProducts characteristic_products(const Impedance& h, const ComplexMatrix& x) {
  if (x.cols() == 0) return {};
  if (!h.quadrature()) return {times(h.stiffness_rr(), x), times(h.gyroscopic_ri(), x), times(h.mass_rr(), x)};
  const Index p = h.split();
  const Index r = h.size() - p;
  const ComplexMatrix first = x.topRows(p), second = x.bottomRows(r);
  CharacteristicProducts y{ComplexMatrix(x.rows(), x.cols()), ComplexMatrix(x.rows(), x.cols()), ComplexMatrix(x.rows(), x.cols())};
  y.k.topRows(p) = times(h.stiffness_rr(), first);
  y.k.bottomRows(r) = times(h.stiffness_ii(), second);
  y.g.topRows(p) = times(h.gyroscopic_ri(), second);
  y.g.bottomRows(r) = -times_transposed(h.gyroscopic_ri(), first);
  y.m.topRows(p) = times(h.mass_rr(), first);
  y.m.bottomRows(r) = times(h.mass_ii(), second);
  return y;
}

void correct_unstable(dense::UnstableRoots& roots, const CharacteristicProducts& p) {
  constexpr int steps = 2;
  for (Index i = 0; i < roots.count(); ++i) {
    const auto y = roots.left.col(i);
    const Complex k = y.dot(p.k.col(i)), g = y.dot(p.g.col(i)), m = y.dot(p.m.col(i));
    Complex& lambda = roots.lambda[static_cast<std::size_t>(i)];
    const bool real = lambda.imag() == 0;
    for (int step = 0; step < steps; ++step) {
      Complex change = -(k + lambda * (g + lambda * m)) / (g + 2.0 * lambda * m);
      if (real) change = change.real();
      const Complex next = lambda + change;
      if (!(std::abs(change) <= 1e-3 * std::abs(lambda)) || !(next.real() > 0) || (!real && !(next.imag() > 0))) break;
      lambda = next;
    }
  }
}

Assessment::Unstable measure_unstable(const Impedance& h, const dense::UnstableRoots& roots, const CharacteristicProducts& p) {
  const Index u = roots.count();
  Assessment::Unstable a{Vector(u), Vector(u), Vector(u), Vector(u)};
  const double rounding = (2 + std::sqrt(static_cast<double>(h.size()))) * epsilon;
  for (Index i = 0; i < u; ++i) {
    const Complex lambda = roots.lambda[static_cast<std::size_t>(i)];
    const double size = std::abs(lambda);
    const ComplexVector r = p.k.col(i) + lambda * p.g.col(i) + (lambda * lambda) * p.m.col(i);
    const auto x = roots.right.col(i), y = roots.left.col(i);
    const Vector weight = h.weight(size);
    const double slope = std::abs(y.dot(p.g.col(i) + 2.0 * lambda * p.m.col(i)));
    const double own_x = weight.dot(x.cwiseAbs2()), own_y = weight.dot(y.cwiseAbs2());
    const double own_scale = std::sqrt(own_x * own_y);
    a.residual(i) = h.given_residual(r, x, size);
    a.own_residual(i) = std::sqrt((weight.array() > 0).select(r.cwiseAbs2().cwiseQuotient(weight), 0).sum() / own_x);
    a.error_bound(i) = (y.cwiseAbs().dot(r.cwiseAbs()) + rounding * own_scale) / slope;
    a.sensitivity(i) = own_scale / slope;
  }
  return a;
}

double span_bound(const Impedance& h, const dense::UnstableRoots& roots, const std::vector<Index>& group) {
  const dense::UnstableRoots part = roots.chosen(group);
  const CharacteristicProducts p = characteristic_products(h, part.right);
  const Assessment::Unstable a = measure_unstable(h, part, p);
  const Index c = part.count();
  ComplexMatrix gram(c, c);
  Vector own_x(c), own_y(c);
  for (Index i = 0; i < c; ++i) {
    const Vector weight = h.weight(std::abs(part.lambda[static_cast<std::size_t>(i)]));
    own_x(i) = weight.dot(part.right.col(i).cwiseAbs2());
    own_y(i) = weight.dot(part.left.col(i).cwiseAbs2());
  }
  double error2 = 0;
  for (Index i = 0; i < c; ++i) {
    const Complex lambda = part.lambda[static_cast<std::size_t>(i)];
    // error_bound · |YᴴN′X| / own scale is the error relative to the own scale, and sensitivity is own scale / |YᴴN′X|.
    error2 += std::pow(a.error_bound(i) / a.sensitivity(i), 2);
    for (Index k = 0; k < c; ++k) gram(k, i) = part.left.col(k).dot(p.g.col(i) + 2.0 * lambda * p.m.col(i)) / std::sqrt(own_x(i) * own_y(k));
  }
  return std::sqrt(error2) / Eigen::JacobiSVD<ComplexMatrix>(gram).singularValues().minCoeff();
}

}  // namespace gyromode
