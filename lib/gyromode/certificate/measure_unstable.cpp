#include "gyromode/certificate/measure_unstable.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

Assessment::Unstable measure_unstable(const Impedance& h, const UnstableRoots& roots, const CharacteristicProducts& p) {
  const Index u = roots.count();
  Assessment::Unstable a{Vector(u), Vector(u), Vector(u), Vector(u)};
  // With a partition Y is X̄ but for signs, and its residual that of X.
  const CharacteristicProducts of_left = h.quadrature() ? CharacteristicProducts{} : h.characteristic_products(roots.left);
  const double rounding = (2 + std::sqrt(static_cast<double>(h.size()))) * epsilon;
  for (Index i = 0; i < u; ++i) {
    const Complex lambda = roots.lambda[static_cast<std::size_t>(i)];
    const double size = std::abs(lambda);
    const ComplexVector r = p.k.col(i) + lambda * p.g.col(i) + (lambda * lambda) * p.m.col(i);
    const auto x = roots.right.col(i), y = roots.left.col(i);
    const Vector weight = h.weight(size);
    const double slope = std::abs(y.dot(p.g.col(i) + 2.0 * lambda * p.m.col(i)));
    const auto in_own_scale = [&](const ComplexVector& residual, double own) {
      return std::sqrt((weight.array() > 0).select(residual.cwiseAbs2().cwiseQuotient(weight), 0).sum() / own);
    };
    const double own_x = weight.dot(x.cwiseAbs2()), own_y = weight.dot(y.cwiseAbs2());
    const double own_scale = std::sqrt(own_x * own_y);
    const Vector of_terms = h.rounding_weight(size);
    const double rounded = rounding * std::sqrt(of_terms.dot(x.cwiseAbs2()) * of_terms.dot(y.cwiseAbs2()));
    a.residual(i) = h.given_residual(r, x, size);
    a.own_residual(i) = in_own_scale(r, own_x);
    if (!h.quadrature()) {
      const Complex mirrored = -std::conj(lambda);
      a.own_residual(i) =
          std::max(a.own_residual(i),
                   in_own_scale(of_left.k.col(i) + mirrored * of_left.g.col(i) + (mirrored * mirrored) * of_left.m.col(i), own_y));
    }
    a.error_bound(i) = (y.cwiseAbs().dot(r.cwiseAbs()) + rounded) / slope;
    a.sensitivity(i) = own_scale / slope;
  }
  return a;
}

double span_bound(const Impedance& h, const UnstableRoots& roots, const std::vector<Index>& group) {
  const UnstableRoots part = roots.chosen(group);
  const CharacteristicProducts p = h.characteristic_products(part.right);
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
    for (Index k = 0; k < c; ++k)
      gram(k, i) = part.left.col(k).dot(p.g.col(i) + 2.0 * lambda * p.m.col(i)) / std::sqrt(own_x(i) * own_y(k));
  }
  return std::sqrt(error2) / small::singular_values(gram).minCoeff();
}

}  // namespace gyromode
