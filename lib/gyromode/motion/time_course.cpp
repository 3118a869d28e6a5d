#include "gyromode/motion/time_course.h"

#include <cmath>

namespace gyromode {

double sinc(double x) { return x == 0 ? 1 : std::sin(x) / x; }

Complex forced(double omega, double nu, double t) {
  // e^{jωt} ∫ e^{j(±ν − ω)s} ds = e^{j(ω ± ν)t/2} t sinc((±ν − ω)t/2)
  const auto half = [&](double way) {
    return 0.5 * t * sinc(0.5 * (way * nu - omega) * t) * std::polar(1.0, 0.5 * (omega + way * nu) * t);
  };
  return half(1) + half(-1);
}

namespace {

// ∫₀¹ u e^{jxu} du.
Complex first_moment(double x) {
  constexpr double small = 0.5;
  const Complex j(0, 1);
  if (std::abs(x) > small) return std::polar(1.0, x) / (j * x) + (std::polar(1.0, x) - 1.0) / (x * x);
  Complex sum = 0, power = 1;  // (jx)^k / k!
  for (int k = 0; k < 16; ++k) {
    sum += power / (k + 2.0);
    power *= j * x / (k + 1.0);
  }
  return sum;
}

}  // namespace

Complex forced_twice(double omega, double nu, double t) {
  const auto half = [&](double way) { return 0.5 * t * t * std::polar(1.0, way * nu * t) * first_moment((omega - way * nu) * t); };
  return half(1) + half(-1);
}

double once_integrated(double nu, double t) { return t * sinc(nu * t); }

double twice_integrated(double nu, double t) {
  const double s = sinc(0.5 * nu * t);
  return 0.5 * t * t * s * s;
}

}  // namespace gyromode
