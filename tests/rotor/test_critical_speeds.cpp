// Critical speeds from one pencil against closed forms, a bisection on H(mΩ), and counts.
#include "gyromode/base/error.h"
#include "gyromode/lapack/small.h"
#include "gyromode/models/model.h"
#include "gyromode/modes/modes.h"
#include "gyromode/read/read_model.h"
#include "gyromode/rotor/rotor.h"
#include "gyromode/sweep/critical_speeds.h"
#include "support/random_matrices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

namespace gyromode {
namespace {

using support::Source;

Index negative_at(const SpinFamily& f, double order, double speed) {
  const SpinFamily::Sum sum = f.sum(speed);
  const double w = order * speed;
  const ComplexMatrix h = (sum.stiffness - w * w * f.mass).cast<Complex>() + Complex(0, w) * sum.gyroscopic.cast<Complex>();
  return static_cast<Index>((small::hermitian_eigenvalues(h).array() < 0).count());
}

// The speed where the count changes, nearest to a guess: between the neighbours half way.
double bisected(const SpinFamily& f, double order, double lo, double hi) {
  const Index at_lo = negative_at(f, order, lo);
  for (int k = 0; k < 60; ++k) {
    const double x = 0.5 * (lo + hi);
    (negative_at(f, order, x) == at_lo ? lo : hi) = x;
  }
  return 0.5 * (lo + hi);
}

TEST(CriticalSpeeds, AreThoseOfABisectionAndNoneIsMissed) {
  Source source{std::mt19937_64(21)};
  Index all = 0;
  for (int draw = 0; draw < 200; ++draw) {
    const Index n = source.integer(2, 10);
    SpinFamily f{source.symmetric(n, 0), Matrix::Zero(n, n), 0.5 * source.skew(n), source.symmetric(n, 0), {}, {}, {}};
    if (draw % 2 == 0) f.stiffness_per_spin2 = 0.3 * source.symmetric(n, n / 2);
    const double order = draw % 3 == 0 ? 1 : draw % 3 == 1 ? 0.25 : 2;
    CriticalOptions o;
    o.order = order;
    const CriticalSpeeds r = critical_speeds(f, o);
    EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << draw << r.coverage.reason;
    EXPECT_EQ(static_cast<Index>(r.speeds.size()) + r.not_physical, n) << draw;
    all += static_cast<Index>(r.speeds.size());
    for (std::size_t k = 0; k < r.speeds.size(); ++k) {
      const double here = r.speeds[k].speed, before = k > 0 ? r.speeds[k - 1].speed : 0,
                   after = k + 1 < r.speeds.size() ? r.speeds[k + 1].speed : 2 * here;
      const double lo = 0.5 * (before + here), hi = 0.5 * (here + after);
      if (hi - lo < 1e-6 * here) continue;
      EXPECT_NEAR(here, bisected(f, order, lo, hi), 1e-10 * here) << draw << " " << k;
      EXPECT_LE(std::abs(here - bisected(f, order, lo, hi)), r.speeds[k].error_bound + 1e-13 * here) << draw;
    }
  }
  EXPECT_GT(all, 300);
}

// Published: a rotor in fixed axes (public question), 96.4975, 306.5442, 891.8617 and 1132.4003 rad/s.
// Stodola and Green: forward and backward critical speeds of an overhung disc on a massless shaft, in closed form.
TEST(CriticalSpeeds, OverhungDisc) {
  const Model model = read_model(std::filesystem::path(GYROMODE_SOURCE_DIR) / "models" / "rotors" / "overhung_disc.toml");
  const CriticalSpeeds r = model.critical_speeds({});
  const double l = 0.3, ei = 2.1e11 * std::numbers::pi / 64 * std::pow(0.03, 4), m = 12, ip = 0.12, id = 0.07;
  // Ω² = ν: (1 − mνL³/3EI)(1 − JνL/EI) = mJν²L⁴/4(EI)², J = I_d ∓ I_p
  std::vector<std::pair<double, Whirl>> exact;
  for (const auto& [inertia, whirl] : {std::pair(id - ip, Whirl::forward), {id + ip, Whirl::backward}}) {
    const double a = m * inertia * std::pow(l, 4) / (12 * ei * ei), b = m * l * l * l / (3 * ei) + inertia * l / ei;
    for (const double sign : {-1.0, 1.0}) {
      const double nu = (b + sign * std::sqrt(b * b - 4 * a)) / (2 * a);
      if (nu > 0) exact.emplace_back(std::sqrt(nu), whirl);
    }
  }
  std::sort(exact.begin(), exact.end());
  ASSERT_EQ(exact.size(), 3U);  // forward: one, as I_p > I_d
  ASSERT_GE(r.speeds.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(r.speeds[k].speed, exact[k].first, 1e-6 * exact[k].first);
    EXPECT_EQ(r.speeds[k].whirl, exact[k].second) << k;
  }
}

// A rigid rotor that is free: K₀ = 0 but for one spring, so that zero modes are taken out.
TEST(CriticalSpeeds, FreeRotorsHaveThoseOfTheirBending) {
  const Model model = read_model(std::filesystem::path(GYROMODE_SOURCE_DIR) / "models" / "rotors" / "free_shaft.toml");
  CriticalOptions o;
  o.window.b = 5000;
  const CriticalSpeeds r = model.critical_speeds(o);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << r.coverage.reason;
  ASSERT_EQ(r.speeds.size(), 2U);
  for (const CriticalSpeed& c : r.speeds) {  // a mode at that speed has that frequency
    ModesOptions window;
    window.window = {0.999 * c.speed, 1.001 * c.speed};
    const ModesResult modes = model.with({{"speed", c.speed}}).modes(window);
    ASSERT_EQ(modes.modes.size(), 1U);
    EXPECT_NEAR(modes.modes[0].omega, c.speed, 1e-9 * c.speed);
  }
}

// Turning axes with K₀ indefinite, and a rotor in turning axes whose whirl at order 0 there is unbalance.
TEST(CriticalSpeeds, WithoutAStiffnessThatHoldsTheSignsAddUpOrItIsSaid) {
  Source source{std::mt19937_64(3)};
  for (int draw = 0; draw < 50; ++draw) {
    const Index n = source.integer(2, 8);
    const SpinFamily f{source.symmetric(n, 0), Matrix::Zero(n, n), source.skew(n), source.symmetric(n, 1), {}, {}, {}};
    const CriticalSpeeds r = critical_speeds(f, {});
    for (const CriticalSpeed& c : r.speeds) {
      const SpinFamily::Sum at = f.sum(c.speed);
      const ComplexMatrix h =
          (at.stiffness - c.speed * c.speed * f.mass).cast<Complex>() + Complex(0, c.speed) * at.gyroscopic.cast<Complex>();
      EXPECT_LE((h * c.shape).norm(), 1e-12 * h.norm() * c.shape.norm()) << draw;
    }
    if (r.coverage.status == CoverageStatus::complete) {
      EXPECT_EQ(r.coverage.counted, r.coverage.found);
    }
  }
}

TEST(CriticalSpeeds, Refusals) {
  const Matrix one = Matrix::Identity(2, 2), g{{0, 1}, {-1, 0}};
  EXPECT_THROW(critical_speeds({one, g, {}, one, {}, {}, {}}, {}), NotApplicable);
  EXPECT_THROW(critical_speeds({one, 0 * g, g, one, {}, {}, {}}, {-1, {}, {}}), InvalidArgument);
}

}  // namespace
}  // namespace gyromode
