// Seeded rotors of every kind: laws to the last bit, all modes counted, critical speeds against the counts of H(mΩ)
// itself, and what must not matter: units, the names of the axes.
#include "gyromode/lapack/small.h"
#include "gyromode/modes/modes.h"
#include "gyromode/sweep/critical_speeds.h"
#include "support/random_rotor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace gyromode {
namespace {

int draws(int otherwise) {
  const char* count = std::getenv("GYROMODE_ROTORS");
  return count ? std::atoi(count) : otherwise;
}

// n₋ of H(mΩ) of the matrices at that speed, by eigenvalues.
Index negative_eigenvalues(const SpinFamily& f, double order, double speed) {
  const SpinFamily::Sum sum = f.sum(speed);
  const double w = order * speed;
  const Vector d = sum.stiffness.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const ComplexMatrix h = (sum.stiffness - w * w * f.mass).cast<Complex>() + Complex(0, w) * sum.gyroscopic.cast<Complex>();
  return static_cast<Index>(
      (small::hermitian_eigenvalues(d.cast<Complex>().asDiagonal() * h * d.cast<Complex>().asDiagonal()).array() < 0).count());
}

TEST(RandomRotors, AreLawfulToTheLastBitAndComplete) {
  support::Source source{std::mt19937_64(7)};
  for (int draw = 0; draw < draws(100); ++draw) {
    const Rotor r(support::random_rotor(source));
    const SpinFamily f = assembled(r);
    EXPECT_EQ(f.mass, Matrix(f.mass.transpose())) << draw;
    EXPECT_EQ(f.stiffness, Matrix(f.stiffness.transpose())) << draw;
    EXPECT_EQ(f.gyroscopic_per_spin, Matrix(-f.gyroscopic_per_spin.transpose())) << draw;
    const ModesResult m = find_modes(f.at(r.parts().speed));
    EXPECT_TRUE(m.repairs.empty());
    EXPECT_TRUE(m.is_complete()) << draw << ": " << m.coverage.reason;
    EXPECT_EQ(m.stability, Stability::stable) << draw;
  }
}

TEST(RandomRotors, CriticalSpeedsAreWhereTheCountsOfTheImpedanceChange) {
  support::Source source{std::mt19937_64(8)};
  Index compared = 0;
  double largest_bound = 0;
  for (int draw = 0; draw < draws(60); ++draw) {
    const Rotor r(support::random_rotor(source));
    const SpinFamily f = assembled(r);
    CriticalOptions o;
    o.order = draw % 3 == 0 ? 1 : draw % 3 == 1 ? 2 : 0.25;
    o.window.b = 4000;
    const CriticalSpeeds c = critical_speeds(f, o);
    ASSERT_EQ(c.coverage.status, CoverageStatus::complete) << draw << ": " << c.coverage.reason;
    EXPECT_EQ(negative_eigenvalues(f, o.order, o.window.b), static_cast<Index>(c.speeds.size())) << draw;  // K₀ > 0
    for (std::size_t k = 0; k < c.speeds.size(); ++k) {
      const double speed = c.speeds[k].speed;
      const double below = k > 0 ? speed - c.speeds[k - 1].speed : speed,
                   above = k + 1 < c.speeds.size() ? c.speeds[k + 1].speed - speed : speed;
      const double step = std::max(1e-10 * speed, 2 * c.speeds[k].error_bound);
      largest_bound = std::max(largest_bound, c.speeds[k].error_bound / speed);
      if (std::min(below, above) < 4 * step) continue;
      EXPECT_EQ(negative_eigenvalues(f, o.order, speed - step), static_cast<Index>(k)) << draw << " " << speed;
      EXPECT_EQ(negative_eigenvalues(f, o.order, speed + step), static_cast<Index>(k) + 1) << draw << " " << speed;
      ++compared;
    }
  }
  std::printf("%ld critical speeds compared, error bounds up to %.1e of the speed\n", static_cast<long>(compared), largest_bound);
}

// Millimetres, newtons and tonnes: the same frequencies, but for rounding that conditioning amplifies.
TEST(RandomRotors, UnitsDoNotMatter) {
  support::Source source{std::mt19937_64(9)};
  for (int draw = 0; draw < 40; ++draw) {
    RotorParts p = support::random_rotor(source), q = p;
    for (Material& m : q.materials) m.young *= 1e-6, m.shear *= 1e-6, m.density *= 1e-12;
    for (Spool& s : q.spools) s.start *= 1e3;
    for (ShaftSection& s : q.shafts) {
      s.length *= 1e3;
      for (int i = 0; i < 2; ++i) s.outer_diameter[i] *= 1e3, s.inner_diameter[i] *= 1e3;
    }
    for (Disc& d : q.discs) {
      d.position *= 1e3, d.offset *= 1e3, d.mass *= 1e-3, d.polar_inertia *= 1e3, d.diametral_inertia *= 1e3;
      if (d.geometry) d.geometry->width *= 1e3, d.geometry->inner_diameter *= 1e3, d.geometry->outer_diameter *= 1e3;
    }
    for (Bearing& b : q.bearings) {
      b.position *= 1e3, b.housing_mass *= 1e-3;
      for (double* k : {&b.kxx, &b.kyy, &b.kxy, &b.housing_kxx, &b.housing_kyy}) *k *= 1e-3;
      for (double* k : {&b.tilt_xx, &b.tilt_yy, &b.tilt_xy}) *k *= 1e3;
    }
    for (Support& s : q.supports) s.position *= 1e3;
    const std::vector<double> a = find_modes(assembled(Rotor(p)).at(p.speed)).frequencies(),
                              b = find_modes(assembled(Rotor(q)).at(p.speed)).frequencies();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-8 * a[k]) << draw << " " << k;
  }
}

// A speed the other way turns forward into backward and leaves frequencies.
TEST(RandomRotors, TheOtherSenseHasTheSameFrequencies) {
  support::Source source{std::mt19937_64(10)};
  for (int draw = 0; draw < 40; ++draw) {
    const SpinFamily f = assembled(Rotor(support::random_rotor(source)));
    const std::vector<double> a = find_modes(f.at(500)).frequencies(), b = find_modes(f.at(-500)).frequencies();
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-9 * a[k]) << draw;
  }
}

}  // namespace
}  // namespace gyromode
