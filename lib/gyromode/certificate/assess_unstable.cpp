#include "gyromode/certificate/assess_unstable.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

void correct_unstable(dense::UnstableRoots& roots, const dense::CharacteristicProducts& p) {
  constexpr int steps = 2;
  for (Index i = 0; i < roots.count(); ++i) {
    const auto y = roots.left.col(i);
    const Complex k = y.dot(p.k.col(i)), g = y.dot(p.g.col(i)), m = y.dot(p.m.col(i));
    const auto residual = [&](Complex at) { return (p.k.col(i) + at * p.g.col(i) + (at * at) * p.m.col(i)).norm(); };
    Complex& lambda = roots.lambda[static_cast<std::size_t>(i)];
    const bool real = lambda.imag() == 0;
    for (int step = 0; step < steps; ++step) {
      Complex change = -(k + lambda * (g + lambda * m)) / (g + 2.0 * lambda * m);
      if (real) change = change.real();
      const Complex next = lambda + change;
      // Near a defective root X turns with λ, and a step that X does not follow makes the pair worse.
      if (!(std::abs(change) <= 1e-3 * std::abs(lambda)) || !(next.real() > 0) || (!real && !(next.imag() > 0)) || !(residual(next) < residual(lambda))) break;
      lambda = next;
    }
  }
}

Assessment::Unstable measure_unstable(const Impedance& h, const dense::UnstableRoots& roots, const dense::CharacteristicProducts& p) {
  const Index u = roots.count();
  Assessment::Unstable a{Vector(u), Vector(u), Vector(u), Vector(u)};
  // With a partition Y is X̄ but for signs, and its residual that of X.
  const dense::CharacteristicProducts of_left = h.quadrature() ? dense::CharacteristicProducts{} : dense::characteristic_products(h, roots.left);
  const double rounding = (2 + std::sqrt(static_cast<double>(h.size()))) * epsilon;
  for (Index i = 0; i < u; ++i) {
    const Complex lambda = roots.lambda[static_cast<std::size_t>(i)];
    const double size = std::abs(lambda);
    const ComplexVector r = p.k.col(i) + lambda * p.g.col(i) + (lambda * lambda) * p.m.col(i);
    const auto x = roots.right.col(i), y = roots.left.col(i);
    const Vector weight = h.weight(size);
    const double slope = std::abs(y.dot(p.g.col(i) + 2.0 * lambda * p.m.col(i)));
    const auto in_own_scale = [&](const ComplexVector& residual, double own) { return std::sqrt((weight.array() > 0).select(residual.cwiseAbs2().cwiseQuotient(weight), 0).sum() / own); };
    const double own_x = weight.dot(x.cwiseAbs2()), own_y = weight.dot(y.cwiseAbs2());
    const double own_scale = std::sqrt(own_x * own_y);
    const Vector of_terms = h.rounding_weight(size);
    const double rounded = rounding * std::sqrt(of_terms.dot(x.cwiseAbs2()) * of_terms.dot(y.cwiseAbs2()));
    a.residual(i) = h.given_residual(r, x, size);
    a.own_residual(i) = in_own_scale(r, own_x);
    if (!h.quadrature()) {
      const Complex mirrored = -std::conj(lambda);
      a.own_residual(i) = std::max(a.own_residual(i), in_own_scale(of_left.k.col(i) + mirrored * of_left.g.col(i) + (mirrored * mirrored) * of_left.m.col(i), own_y));
    }
    a.error_bound(i) = (y.cwiseAbs().dot(r.cwiseAbs()) + rounded) / slope;
    a.sensitivity(i) = own_scale / slope;
  }
  return a;
}

double span_bound(const Impedance& h, const dense::UnstableRoots& roots, const std::vector<Index>& group) {
  const dense::UnstableRoots part = roots.chosen(group);
  const dense::CharacteristicProducts p = dense::characteristic_products(h, part.right);
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
  return std::sqrt(error2) / small::singular_values(gram).minCoeff();
}

}  // namespace gyromode
