// The fields of wires against Legendre functions of any degree in ball arithmetic (Arb): the angle of (value, slope) at
// the root, for degrees up to 300, any root, any tip mass.
#include "gyromode/appendage/wire_field.h"

#include <arb_hypgeom.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gyromode {
namespace {

slong bits = 200;  // of the sample at hand: the series of P_ν loses 0.57 ν digits, that of P_ν(−z) more

class Ball {
 public:
  explicit Ball(double x = 0) {
    arb_init(x_);
    arb_set_d(x_, x);
  }
  Ball(const Ball& o) {
    arb_init(x_);
    arb_set(x_, o.x_);
  }
  Ball& operator=(const Ball& o) {
    arb_set(x_, o.x_);
    return *this;
  }
  ~Ball() { arb_clear(x_); }
  arb_ptr get() { return x_; }
  arb_srcptr get() const { return x_; }
  double value() const { return arf_get_d(arb_midref(x_), ARF_RND_NEAR); }

  friend Ball operator+(const Ball& a, const Ball& b) { return by(arb_add, a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return by(arb_sub, a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return by(arb_mul, a, b); }
  friend Ball operator/(const Ball& a, const Ball& b) { return by(arb_div, a, b); }
  friend Ball sqrt(const Ball& a) {
    Ball r;
    arb_sqrt(r.x_, a.x_, bits);
    return r;
  }

 private:
  template <class Operation>
  static Ball by(Operation operation, const Ball& a, const Ball& b) {
    Ball r;
    operation(r.x_, a.x_, b.x_, bits);
    return r;
  }
  arb_t x_;
};

struct Solution {
  Ball value, slope;  // slope times 1 − z²
};

// P_ν(±z) on the cut and (1 − z²) times its derivative by z; P_ν: ν(P_{ν−1} − zP_ν). P_ν(−z) is the second solution, ν
// not whole.
Solution solution(const Ball& nu, const Ball& z, bool mirrored) {
  const Ball order(0), at = mirrored ? Ball(0) - z : z, less = nu - Ball(1);
  Solution s;
  Ball before;
  arb_hypgeom_legendre_p(s.value.get(), nu.get(), order.get(), at.get(), 0, bits);
  arb_hypgeom_legendre_p(before.get(), less.get(), order.get(), at.get(), 0, bits);
  s.slope = nu * (before - at * s.value);
  if (mirrored) s.slope = Ball(0) - s.slope;
  return s;
}

// Regular at the tip, or with a tip mass Φ′(z_t) = cλΦ(z_t), z_t = 1/c: (1 − z_t²)Φ′ = kΦ with k = (1 − z_t²)cλ.
Solution exact(double lambda, double z_root, double ratio) {
  const Ball l(lambda), z(z_root);
  const Ball nu = (sqrt(Ball(1) + Ball(8) * l) - Ball(1)) / Ball(2);
  const Solution p = solution(nu, z, false);
  if (ratio == 0) return p;
  const Ball c = sqrt(Ball(1) + Ball(2) * Ball(ratio)), tip = Ball(1) / c, k = (Ball(1) - tip * tip) * c * l;
  const Solution pt = solution(nu, tip, false), qt = solution(nu, tip, true), q = solution(nu, z, true);
  const Ball a = qt.slope - k * qt.value, b = k * pt.value - pt.slope;
  return {a * p.value + b * q.value, a * p.slope + b * q.slope};
}

TEST(WireFieldArb, PhaseAtTheRoot) {
  std::mt19937_64 engine(7);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
  for (int k = 0; k < 400; ++k) {
    const double nu = std::exp(between(std::log(0.05), std::log(300)));
    const double lambda = 0.5 * nu * (nu + 1);
    bits = 200 + static_cast<slong>(6 * nu);
    const double ratio = k % 3 == 0 ? 0 : std::exp(between(std::log(1e-6), std::log(30)));
    const double tip = 1 / std::sqrt(1 + 2 * ratio);
    const double z = between(0.01, 0.9) * tip;
    const WireField<double> f = wire_fields(lambda, z, ratio)[1];
    const Solution s = exact(lambda, z, ratio);
    // Directions in units in which both oscillate alike: value and slope/(ν√(1 − z²)).
    const double unit = (1 + nu) * std::sqrt(1 - z * z);
    const double size = std::hypot(f.value, f.slope / unit);
    const Ball length = sqrt(s.value * s.value + s.slope * s.slope / (Ball(unit) * Ball(unit)));
    const double sine = ((Ball(f.value) * s.slope - Ball(f.slope) * s.value) / (length * Ball(unit))).value() / size;
    // Errors of the phase: rounding of each of some ν steps; beside a light tip mass the start is steep.
    const double bound = 4e-15 + 2.5e-16 * nu * std::sqrt(nu) + 1e-16 * nu * nu;
    EXPECT_LE(std::abs(sine), bound) << "nu " << nu << ", z " << z << ", mu " << ratio;
  }
}

}  // namespace
}  // namespace gyromode
