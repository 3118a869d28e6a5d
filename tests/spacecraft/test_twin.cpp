// Exact against discrete: orders of convergence, extrapolated frequencies, and inertia counts of the twin of finite
// elements, which shares no formula with the exact fields.
#include "support/random_spacecraft.h"

#include "gyromode/dense/inertia.h"
#include "gyromode/elements/discretise.h"
#include "gyromode/elements/spin_phase.h"
#include "gyromode/roots/blocks.h"
#include "gyromode/modes/discrete.h"
#include "gyromode/modes/spacecraft.h"
#include "gyromode/spacecraft/spacecraft_impedance.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>
#include <random>

namespace gyromode {
namespace {

Spacecraft geos() {
  const double h = -0.2511013215859031;
  return Spacecraft(1.0471975511965976, {272.4, Eigen::Vector3d(85, 100, 120).asDiagonal()},
                    {{0.5 * std::numbers::pi, 0.825, h, 20, 0.03, 0}, {1.5 * std::numbers::pi, 0.825, h, 20, 0.03, 0}});
}

std::vector<double> vibrations(const ModesResult& r) {
  std::vector<double> omega;
  for (const Mode& m : r.modes) {
    if (m.kind != ModeKind::rigid_body) omega.push_back(m.omega);
  }
  return omega;
}

// Linear elements: errors fall fourfold when the elements are halved, and what is extrapolated from three meshes is the
// exact frequency.
TEST(Twin, LinearElementsConvergeToTheExactFrequenciesOfGeos) {
  const Spacecraft s = geos();
  ModesOptions options;
  options.window.b = 3 * s.spin();
  const std::vector<double> exact = vibrations(find_modes(s, options));
  std::vector<std::vector<double>> mesh;
  for (const Index elements : {60, 120, 240}) mesh.push_back(vibrations(find_modes(s, Mesh{elements, 1}, options)));
  ASSERT_EQ(exact.size(), 9u);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double e0 = mesh[0][i] / exact[i] - 1, e1 = mesh[1][i] / exact[i] - 1, e2 = mesh[2][i] / exact[i] - 1;
    EXPECT_NEAR(std::log2(e0 / e1), 2, 0.02) << exact[i];
    EXPECT_NEAR(std::log2(e1 / e2), 2, 0.01) << exact[i];
    // Richardson twice: the errors go by h², h⁴.
    const double once0 = (4 * mesh[1][i] - mesh[0][i]) / 3, once1 = (4 * mesh[2][i] - mesh[1][i]) / 3;
    EXPECT_NEAR((16 * once1 - once0) / 15, exact[i], 2e-9 * exact[i]);
  }
}

// All 56 + 27 + 27 modes below 40 spins, against two elements of degree 44 a wire.
TEST(Twin, GeosBelowFortySpins) {
  const Spacecraft s = geos();
  ModesOptions options;
  options.window.b = 40 * s.spin();
  const std::vector<double> exact = vibrations(find_modes(s, options));
  const std::vector<double> fine = vibrations(find_modes(s, Mesh{2, 44}, options));
  ASSERT_EQ(exact.size(), 109u);
  ASSERT_EQ(fine.size(), exact.size());
  // rounding of the twin, of its highest frequency
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(fine[i], exact[i], 2e-11 * exact[i]) << i;
}

Index exact_count(const SpacecraftImpedance& impedance, const std::vector<Block>& blocks, double omega) {
  const Lifted lifted = impedance.at(omega);
  Index count = -3;  // ξ1, ξ2, ξ3, which the twin eliminates
  for (const Block& b : blocks) count += state_of(b, lifted).count * b.copies();
  return count;
}

std::size_t wanted(const char* variable, std::size_t usual) {
  const char* asked = std::getenv(variable);
  return asked ? std::strtoull(asked, nullptr, 10) : usual;
}

// J(ω) of the exact impedance is n₋ of the twin's H(ω) at random frequencies, 30 satellites; beside Ω, where the tilt
// is, the twin is asked a little farther off.
TEST(Twin, CountsAgree) {
  const std::size_t frequencies = wanted("GYROMODE_COUNTS", 200);
  constexpr double twin_error = 1e-4;
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Spacecraft s = random_spacecraft(seed);
    const SpacecraftImpedance impedance(s);
    const std::vector<Block> blocks = blocks_of(impedance);
    const System twin = discretise(s, {1, 12});
    const auto twin_count = [&](double omega) { return inertia(twin.impedance(omega * s.spin())).negative; };
    std::mt19937_64 engine(seed);
    for (std::size_t k = 0; k < frequencies; ++k) {
      const double omega = std::uniform_real_distribution<double>(0.01, 6)(engine);
      // Where the exact count changes nearby, the twin's may have changed already.
      if (exact_count(impedance, blocks, omega * (1 - twin_error)) != exact_count(impedance, blocks, omega * (1 + twin_error))) continue;
      ASSERT_EQ(exact_count(impedance, blocks, omega), twin_count(omega)) << "seed " << seed << ", omega " << omega;
      ++compared;
    }
    const Index below = exact_count(impedance, blocks, 1 - 1e-12), above = exact_count(impedance, blocks, 1 + 1e-12);
    if (exact_count(impedance, blocks, 1 - 1e-5) == below && exact_count(impedance, blocks, 1 + 1e-5) == above) {
      EXPECT_EQ(below, twin_count(1 - 1e-5)) << seed;
      EXPECT_EQ(above, twin_count(1 + 1e-5)) << seed;
    }
    EXPECT_EQ(std::abs(above - below), 1) << "the tilt, seed " << seed;
  }
  EXPECT_GE(compared, 28 * frequencies);
}

// Certified wherever the static stiffness is not indefinite, and where it is, wherever the balance closes; frequencies
// are those of the twin to the twin's own error, seen from two meshes.
TEST(RandomSatellites, AreCertified) {
  const std::size_t satellites = wanted("GYROMODE_SATELLITES", 100);
  std::size_t open = 0;
  for (std::uint64_t seed = 1000; seed < 1000 + satellites; ++seed) {
    const Spacecraft s = random_spacecraft(seed);
    ModesOptions options;
    options.window.b = 5 * s.spin();
    const ModesResult r = find_modes(s, options);
    if (r.stiffness.definiteness() != Definiteness::indefinite) {
      ASSERT_EQ(r.coverage.status, CoverageStatus::complete) << "seed " << seed << ": " << r.coverage.reason;
      ASSERT_EQ(r.stability, Stability::stable) << seed;
    }
    if (!r.index_balance.closed) {
      ++open;
      continue;
    }
    ASSERT_EQ(r.coverage.status, CoverageStatus::complete) << "seed " << seed << ": " << r.coverage.reason;
    // The counts of the twin between the exact frequencies, wherever it is fine enough to tell them apart.
    const System twin = discretise(s, {1, 12});
    constexpr double gap = 2e-3;
    Index expected = -1;
    for (std::size_t i = 0; i + 1 < r.modes.size(); ++i) {
      if (r.modes[i].omega == 0 || r.modes[i + 1].omega - r.modes[i].omega < gap * r.modes[i].omega) {
        if (expected >= 0 && r.modes[i].omega > 0) expected += r.modes[i].energy_sign;
        continue;
      }
      if (expected >= 0) expected += r.modes[i].energy_sign;
      const Index counted = inertia(twin.impedance(0.5 * (r.modes[i].omega + r.modes[i + 1].omega))).negative;
      if (expected >= 0) {
        ASSERT_EQ(counted, expected) << "seed " << seed << " above " << r.modes[i].omega / s.spin();
      }
      expected = counted;
    }
  }
  EXPECT_LE(open, satellites / 50);
}

// Growing motions of the exact impedance are those of the twin to its own error, and where they are all, the balance
// closes.
TEST(RandomSatellites, GrowthRatesAreThoseOfTheTwin) {
  std::size_t growing = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Spacecraft s = random_spacecraft(seed);
    ModesOptions options;
    options.lowest = 1;
    const ModesResult exact = find_modes(s, options);
    if (exact.unstable.empty()) continue;
    const WithoutSpinPhase twin(discretise(s, {1, 14}), spin_phase_of_twin);
    const ModesResult fine = find_modes(low_modes(twin.system(), 200 * s.spin()));
    for (const UnstableMode& u : exact.unstable) {
      EXPECT_LE(u.residual, 1e-9) << seed;
      EXPECT_GT(u.error_bound, 0) << seed;
      EXPECT_LE(u.error_bound, 1e-6 * std::hypot(u.growth_rate, u.omega)) << seed;
      double nearest = 1;
      for (const UnstableMode& f : fine.unstable)
        nearest = std::min(nearest, std::hypot(f.growth_rate - u.growth_rate, f.omega - u.omega) / std::hypot(u.growth_rate, u.omega));
      EXPECT_LE(nearest, 2e-5) << "seed " << seed << ": " << u.growth_rate / s.spin() << " + j " << u.omega / s.spin();
      ++growing;
    }
    EXPECT_TRUE(exact.index_balance.closed) << seed;
  }
  EXPECT_GE(growing, 20u);
}

}  // namespace
}  // namespace gyromode
