#include "gyromode/appendage/legendre.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Φ and Φ′ (by z) at z = 1 − distance, up to a common factor. A small tip mass starts at 1 − μ: the distance keeps its digits.
struct Point {
  double distance, value, slope;
};

// P_ν = Σ a_k t^k, t = (1 − z)/2, a_{k+1}/a_k = (k(k + 1) − 2λ)/(k + 1)²: the first step from z = 1, where the Taylor series has no radius.
Point from_regular_end(double two_lambda, double z_root) {
  const double t = std::min({0.25, 1 / std::max(std::abs(two_lambda), 1e-300), 0.5 * (1 - z_root)});
  double term = 1;
  double value = 1;
  double slope = 0;  // by t
  for (int k = 0; k < 200; ++k) {
    const double n = k;
    const double ratio = (n * (n + 1) - two_lambda) / ((n + 1) * (n + 1));
    slope += term * ratio * (n + 1);
    term *= ratio * t;
    value += term;
    if (std::abs(term) * (n + 2) <= 0.25 * epsilon * std::abs(value)) break;
  }
  return {2 * t, value, -0.5 * slope};
}

// By −step along z; the Taylor series about z, c_k: (1 − z²)(k + 2)(k + 1)c_{k+2} = 2z(k + 1)²c_{k+1} + (k(k + 1) − 2λ)c_k.
Point stepped(const Point& p, double two_lambda, double step) {
  const double z = 1 - p.distance;
  const double w = p.distance * (2 - p.distance);
  step = -step;
  double before = p.value;         // c_k step^k
  double now = p.slope * step;     // c_{k+1} step^{k+1}
  double value = before + now;
  double slope = now;              // times step
  const double size = std::abs(before) + std::abs(now);
  for (int k = 0; k < 400; ++k) {
    const double n = k;
    const double next = (2 * z * (n + 1) * (n + 1) * now * step + (n * (n + 1) - two_lambda) * before * step * step) / (w * (n + 2) * (n + 1));
    value += next;
    slope += (n + 2) * next;
    before = now;
    now = next;
    if ((n + 3) * (std::abs(before) + std::abs(now)) <= 0.25 * epsilon * size) break;
  }
  return {p.distance - step, value, slope / step};
}

}  // namespace

WireField wire_field(double lambda, double z_root, double tip_mass_ratio) {
  const double two_lambda = 2 * lambda;
  const double c = std::sqrt(1 + 2 * tip_mass_ratio);
  Point p = tip_mass_ratio > 0 ? Point{2 * tip_mass_ratio / (c * (c + 1)), 1, c * lambda} : from_regular_end(two_lambda, z_root);
  const double end = 1 - z_root;
  WireField field;
  bool positive = true;
  while (p.distance < end) {
    const double phase = 1.5 * std::sqrt(p.distance * (2 - p.distance)) / std::sqrt(std::max(std::abs(two_lambda), 1e-300));
    const double longest = std::min({0.5 * p.distance, phase, 0.5});
    const double left = end - p.distance;
    const bool last = longest >= left;
    p = stepped(p, two_lambda, last ? left : longest);
    if (last) p.distance = end;
    const double size = std::max(std::abs(p.value), std::abs(p.slope) * p.distance);  // keeps an exponential (λ < 0) within range
    p.value /= size;
    p.slope /= size;
    if (p.value != 0 && (p.value > 0) != positive) {
      positive = !positive;
      ++field.zeros;
    }
  }
  field.chi = p.slope / p.value;
  return field;
}

}  // namespace gyromode
