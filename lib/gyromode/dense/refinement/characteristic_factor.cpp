#include "gyromode/dense/refinement/characteristic_factor.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/complex_lu.h"
#include "gyromode/system/scale.h"

#include <cmath>
#include <numbers>

namespace gyromode::dense {

namespace {

// D N D with rows and columns near 1 (|N| is symmetric), and D.
struct Equilibrated {
  Vector d;
  lapack::ComplexLu lu;
};

Vector scale_at(const Impedance& h, double size) {
  return h.weight(size).unaryExpr([](double w) { return w > 0 ? power_of_two_near(1 / std::sqrt(w)) : 1; });
}

Equilibrated factored(const Impedance& h, Complex lambda) {
  const Vector d = scale_at(h, std::abs(lambda));
  return {d, lapack::ComplexLu(scaled(h.characteristic_at(lambda), d))};
}

NullPair iterated(const Equilibrated& f, Index n) {
  ComplexVector start(n);  // no structure makes it orthogonal to a null vector
  for (Index i = 0; i < n; ++i) start(i) = std::polar(1.0, 0.7 + 1.9 * static_cast<double>(i * i % 97));
  NullPair v{start, start};
  for (int step = 0; step < 2; ++step) {
    v.right = f.lu.solve(v.right).col(0).normalized();
    v.left = f.lu.solve_adjoint(v.left).col(0).normalized();
  }
  v.right = (f.d.asDiagonal() * v.right).normalized().eval();
  v.left = (f.d.asDiagonal() * v.left).normalized().eval();
  return v;
}

}  // namespace

NullPair null_pair(const Impedance& h, Complex lambda) {
  NullPair v = iterated(factored(h, lambda), h.size());
  // A matrix that is singular to the last bit has no inverse to iterate with; one rounding error away it has.
  for (double shift = 2 * epsilon; shift < 1e-12 && !(v.right.allFinite() && v.left.allFinite()); shift *= 8) {
    const Vector d = scale_at(h, std::abs(lambda));
    ComplexMatrix n = scaled(h.characteristic_at(lambda), d);
    n.diagonal().array() += shift;
    v = iterated({d, lapack::ComplexLu(std::move(n))}, h.size());
  }
  return v;
}

Complex logarithmic_slope(const Impedance& h, Complex lambda) {
  const Equilibrated f = factored(h, lambda);
  return f.lu.solve(scaled(h.characteristic_slope_at(lambda), f.d)).trace();
}

std::optional<DiscCount> roots_in_disc(const Impedance& h, Complex centre, double radius) {
  constexpr Index first = 8, most = 256;
  constexpr double integer_to = 0.01;
  // Points of the doubled rule lie between those of the one before.
  Complex sum = 0, moment = 0;
  Index points = 0;
  const auto add = [&](double turn) {
    const Complex step = std::polar(radius, 2 * std::numbers::pi * turn);
    const Complex term = step * logarithmic_slope(h, centre + step);
    sum += term;
    moment += step * term;
    ++points;
  };
  Index before = -1;  // none yet
  for (Index m = first; m <= most; m *= 2) {
    for (Index k = 0; k < m; ++k) {
      if (m == first || k % 2 == 1) add(static_cast<double>(k) / static_cast<double>(m));
    }
    const Complex mean = sum / static_cast<double>(points);
    const double rounded = std::round(mean.real());
    if (!(std::abs(mean - rounded) <= integer_to)) {
      before = -1;
      continue;
    }
    const Index roots = static_cast<Index>(rounded);
    if (before == roots) return DiscCount{roots, roots == 0 ? centre : centre + moment / (static_cast<double>(points) * rounded)};
    before = roots;
  }
  return std::nullopt;
}

std::optional<DiscCount> Impedance::roots_in_disc(Complex centre, double radius) const {
  return dense::roots_in_disc(*this, centre, radius);
}

}  // namespace gyromode::dense
