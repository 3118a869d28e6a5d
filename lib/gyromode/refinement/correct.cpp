#include "gyromode/refinement/correct.h"

#include "gyromode/certificate/measure_unstable.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode {

namespace {

// The root of a functional near ω. A step is taken while it shrinks |value| and stays a small part of ω.
double corrected(const Functional& f, double omega) {
  if (!f.second_order) return f.g / f.m;
  for (int step = 0; step < 3; ++step) {
    const double next = omega + f.value(omega) / f.slope(omega);
    if (!(std::abs(next - omega) <= 1e-3 * omega) || !(std::abs(f.value(next)) < std::abs(f.value(omega)))) break;
    omega = next;
  }
  return omega;
}

void move(UnstableRoots& roots, const CharacteristicProducts& p) {
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
      if (!(std::abs(change) <= 1e-3 * std::abs(lambda)) || !(next.real() > 0) || (!real && !(next.imag() > 0)) ||
          !(residual(next) < residual(lambda)))
        break;
      lambda = next;
    }
  }
}

// The positions of the roots in ascending order; empty where they are.
std::vector<Index> ascending(const Spectrum& s) {
  if (std::is_sorted(s.omega.begin(), s.omega.end())) return {};
  std::vector<Index> order(static_cast<std::size_t>(s.omega.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index i, Index k) { return s.omega(i) < s.omega(k); });
  return order;
}

void reorder(Spectrum& s, const std::vector<Index>& order) {
  s.omega = Vector(s.omega(order));
  s.re = Matrix(s.re(Eigen::all, order));
  s.im = Matrix(s.im(Eigen::all, order));
}

}  // namespace

void sort_by_frequency(Spectrum& s) {
  if (const std::vector<Index> order = ascending(s); !order.empty()) reorder(s, order);
}

Assessment correct(const Impedance& h, Spectrum& s) {
  Products p = products(h, s);
  for (Index i = 0; i < s.omega.size(); ++i) s.omega(i) = corrected(p.functional(i), s.omega(i));
  if (const std::vector<Index> order = ascending(s); !order.empty()) {
    reorder(s, order);
    p.reorder(order);
  }
  const CharacteristicProducts of_unstable = h.characteristic_products(s.unstable.right);
  move(s.unstable, of_unstable);
  return measure(h, s, p, of_unstable);
}

Assessment::Unstable correct_unstable(const Impedance& h, Spectrum& s) {
  const CharacteristicProducts p = h.characteristic_products(s.unstable.right);
  move(s.unstable, p);
  return measure_unstable(h, s.unstable, p);
}

}  // namespace gyromode
