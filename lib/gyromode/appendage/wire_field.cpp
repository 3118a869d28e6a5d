#include "gyromode/appendage/wire_field.h"

#include "gyromode/base/rounding.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

constexpr int lanes = 2;
constexpr int most_terms = 400;

template <class T>
using Pair = std::array<T, lanes>;

// 1/(k + 1) … for the recurrences, so that nothing is divided in the loops.
struct Reciprocals {
  std::array<double, most_terms + 8> of{};
  constexpr Reciprocals() {
    for (std::size_t k = 0; k < of.size(); ++k) of[k] = 1 / (static_cast<double>(k) + 1);
  }
  double operator()(int n) const { return of[static_cast<std::size_t>(n - 1)]; }  // 1/n
};
constexpr Reciprocals inverse;

// Φ and Φ′ at z = 1 − distance with the integrals from there to the tip. A small tip mass starts at 1 − μ: the distance
// keeps its digits.
template <class T>
struct March {
  double distance = 0;
  Pair<T> value{}, slope{}, force{}, moment{}, tip{1, 1};
};

// P_ν = Σ a_k t^k, t = (1 − z)/2, a_{k+1}/a_k = (k(k + 1) − 2λ)/(k + 1)²: the first step from z = 1, where the Taylor
// series has no radius.
template <class T>
March<T> from_regular_end(const Pair<T>& two_lambda, double largest, double z_root) {
  const double t = std::min({0.25, 1 / std::max(largest, 1e-300), 0.5 * (1 - z_root)});
  March<T> m;
  m.distance = 2 * t;
  for (std::size_t i = 0; i < lanes; ++i) {
    T term = 1;
    T slope = 0;  // by t
    m.value[i] = 1;
    m.force[i] = 2 * t;
    m.moment[i] = 2 * t - 2 * t * t;
    for (int k = 0; k < most_terms; ++k) {
      const double n = k;
      const T ratio = (n * (n + 1) - two_lambda[i]) / ((n + 1) * (n + 1));
      slope += term * ratio * (n + 1);
      term *= ratio * t;
      m.value[i] += term;
      m.force[i] += 2 * t * term / (n + 2);
      m.moment[i] += 2 * t * term / (n + 2) - 4 * t * t * term / (n + 3);
      if (std::abs(term) * (n + 2) <= 0.25 * epsilon * std::abs(m.value[i])) break;
    }
    m.slope[i] = -0.5 * slope;
  }
  return m;
}

template <class T>
March<T> from_tip_mass(const Pair<T>& two_lambda, double ratio) {
  const double c = std::sqrt(1 + 2 * ratio);
  March<T> m;
  m.distance = 2 * ratio / (c * (c + 1));
  for (std::size_t i = 0; i < lanes; ++i) {
    m.value[i] = 1;
    m.slope[i] = 0.5 * c * two_lambda[i];
    m.force[i] = ratio / c;
    m.moment[i] = ratio / (c * c);
  }
  return m;
}

// By −step along z; the Taylor series about z, c_k: (1 − z²)(k + 2)(k + 1)c_{k+2} = 2z(k + 1)²c_{k+1} + (k(k + 1) −
// 2λ)c_k. The integrals only where asked for.
template <bool integrals, class T>
void advance(March<T>& m, const Pair<T>& two_lambda, double step) {
  const double z = 1 - m.distance;
  const double w = m.distance * (2 - m.distance);
  const double first = -2 * z * step / w;
  const double second = step * step / w;
  Pair<T> before, now, value, slope, force{}, lever{};
  double size = 0;
  for (std::size_t i = 0; i < lanes; ++i) {
    before[i] = m.value[i];       // c_k h^k, h = −step
    now[i] = -step * m.slope[i];  // c_{k+1} h^{k+1}
    value[i] = before[i] + now[i];
    slope[i] = now[i];
    if constexpr (integrals) {
      force[i] = before[i] + 0.5 * now[i];               // ∫ Φ over the step, by h
      lever[i] = 0.5 * before[i] + inverse(3) * now[i];  // ∫ (z′ − z) Φ, by h²
    }
    size = std::max(size, std::abs(before[i]) + std::abs(now[i]));
  }
  constexpr int stride = 4;  // terms between looks at what is left
  for (int k = 0; k < most_terms; k += stride) {
    for (int j = k; j < k + stride; ++j) {
      const double n = j;
      const double a = first * (n + 1) * inverse(j + 2);
      const double b = second * inverse(j + 1) * inverse(j + 2);
      for (std::size_t i = 0; i < lanes; ++i) {
        const T next = a * now[i] + (b * (n * (n + 1) - two_lambda[i])) * before[i];
        value[i] += next;
        slope[i] += (n + 2) * next;
        if constexpr (integrals) {
          force[i] += inverse(j + 3) * next;
          lever[i] += inverse(j + 4) * next;
        }
        before[i] = now[i];
        now[i] = next;
      }
    }
    double left = 0;
    for (std::size_t i = 0; i < lanes; ++i) left = std::max(left, std::abs(before[i]) + std::abs(now[i]));
    if ((k + stride + 2) * left <= 0.25 * epsilon * size) break;
  }
  for (std::size_t i = 0; i < lanes; ++i) {
    if constexpr (integrals) {
      m.force[i] += step * force[i];
      m.moment[i] += step * (z * force[i] - step * lever[i]);
    }
    m.value[i] = value[i];
    m.slope[i] = slope[i] / -step;
  }
  m.distance += step;
}

template <class T>
Pair<T> twice(const Pair<T>& lambda) {
  return {2.0 * lambda[0], 2.0 * lambda[1]};
}

template <class T>
March<T> started(const Pair<T>& two_lambda, double largest, double z_root, double tip_mass_ratio) {
  return tip_mass_ratio > 0 ? from_tip_mass(two_lambda, tip_mass_ratio) : from_regular_end(two_lambda, largest, z_root);
}

// The longest step that turns the phase by less than π, so that it holds one zero at most, and stays within half the
// radius of the series.
double longest_step(double distance, double largest) {
  const double phase = 2.2 * std::sqrt(distance * (2 - distance)) / std::sqrt(std::max(largest, 1e-300));
  return std::min({0.5 * distance, phase, 0.5});
}

// Keeps an exponential (λ < 0) within range. A complex λ, of some moderate growing motion, must stay analytic and is
// left alone.
void normalise(March<double>& m) {
  for (std::size_t i = 0; i < lanes; ++i) {
    const double size = std::max(std::abs(m.value[i]), std::abs(m.slope[i]) * m.distance);
    for (double* x : {&m.value[i], &m.slope[i], &m.force[i], &m.moment[i], &m.tip[i]}) *x /= size;
  }
}
void normalise(March<Complex>&) {}

bool below_zero(double x, bool before) { return x == 0 ? before : x < 0; }
bool below_zero(const Complex&, bool) { return false; }

// (1 − z²)(zΦ′ − Φ) = 2(λ − 1) · moment: of Φ near λ = 1, where it is nearly z, what is left at a root near the axis.
template <class T>
T value_near_one(const T& slope, const T& moment, const T& less_one, double z, double w) {
  return (z * w * slope - 2.0 * less_one * moment) / w;
}

template <class T>
std::array<WireField<T>, lanes> fields(const T& lambda, double z_root, double tip_mass_ratio) {
  const Pair<T> two_lambda = twice(Pair<T>{1.0 + lambda, lambda});
  const double largest = std::max(std::abs(two_lambda[0]), std::abs(two_lambda[1]));
  March<T> m = started(two_lambda, largest, z_root, tip_mass_ratio);
  const double end = 1 - z_root;
  const double w = (1 - z_root) * (1 + z_root);
  // Beyond some waves the integrals follow from value and slope, free of the cancellation that their sum has.
  constexpr double waves = 6;
  const bool many_waves = std::abs(two_lambda[0]) > waves && std::abs(two_lambda[1]) > waves;
  std::array<WireField<T>, lanes> found;
  Pair<bool> negative{};
  while (m.distance < end) {
    const double longest = longest_step(m.distance, largest);
    const double left = end - m.distance;
    const bool last = longest >= left;
    if (many_waves)
      advance<false>(m, two_lambda, last ? left : longest);
    else
      advance<true>(m, two_lambda, last ? left : longest);
    if (last) m.distance = end;
    normalise(m);
    constexpr double near = 0.25;
    if (last && std::abs(lambda) < near) m.value[0] = value_near_one(m.slope[0], m.moment[0], lambda, z_root, w);
    for (std::size_t i = 0; i < lanes; ++i) {
      const bool now = below_zero(m.value[i], negative[i]);
      if (now != negative[i]) ++found[i].zeros;
      negative[i] = now;
    }
  }
  for (std::size_t i = 0; i < lanes; ++i) {
    WireField<T>& f = found[i];
    f.value = m.value[i];
    f.tip = m.tip[i];
    f.slope = w * m.slope[i];
    f.force = many_waves ? f.slope / two_lambda[i] : m.force[i];  // (1 − z²)Φ′ = 2λ · force, (1 − z²)(zΦ′ − Φ) = 2(λ − 1) · moment
    f.moment = many_waves ? (z_root * f.slope - w * f.value) / (two_lambda[i] - 2.0) : m.moment[i];
  }
  return found;
}

}  // namespace

std::array<WireField<double>, 2> wire_fields(double lambda, double z_root, double tip_mass_ratio) {
  return fields(lambda, z_root, tip_mass_ratio);
}

std::array<WireField<Complex>, 2> wire_fields(Complex lambda, double z_root, double tip_mass_ratio) {
  return fields(lambda, z_root, tip_mass_ratio);
}

template <class T>
std::vector<T> wire_shape(const T& lambda, const std::vector<double>& z, double tip_mass_ratio) {
  const Pair<T> two_lambda{2.0 * lambda, 2.0 * lambda};
  const double largest = std::abs(two_lambda[0]);
  std::vector<T> shape;
  if (z.empty()) return shape;
  March<T> m = started(two_lambda, largest, z.back(), tip_mass_ratio);
  const March<T> start = m;
  for (const double at : z) {
    if (1 - at <= start.distance && tip_mass_ratio == 0) {  // within the first series
      shape.push_back(1 - at <= 0 ? T(1) : from_regular_end(two_lambda, largest, at).value[0]);
      continue;
    }
    while (m.distance < 1 - at) advance<false>(m, two_lambda, std::min(longest_step(m.distance, largest), 1 - at - m.distance));
    shape.push_back(m.value[0]);
  }
  return shape;
}

template std::vector<double> wire_shape(const double&, const std::vector<double>&, double);
template std::vector<Complex> wire_shape(const Complex&, const std::vector<double>&, double);

}  // namespace gyromode
