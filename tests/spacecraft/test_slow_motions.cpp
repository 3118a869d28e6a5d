// Divergence and negative energy as slow as one likes: on either side of the value at which the static stiffness is
// singular a verdict is found, and the right one.
#include "support/random_spacecraft.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/roots/static_count.h"
#include "gyromode/modes/spacecraft.h"
#include "gyromode/spacecraft/spacecraft_impedance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace gyromode {
namespace {

constexpr double pi = std::numbers::pi;
ModesResult solved(const Spacecraft& s) {
  ModesOptions options;
  options.lowest = 1;
  return find_modes(s, options);
}

Body body(double j3) { return {310, Eigen::Vector3d(100, 110, j3).asDiagonal()}; }

// Where J₃ passes J₁ and J₂ of a rigid body: |λ²| = Ω²|J₃ − J₁||J₃ − J₂|/(J₁J₂), divergence between them, negative
// energy below.
TEST(SlowMotions, OfARigidBody) {
  constexpr double spin = 0.7;
  for (const double delta : {10.0 / 3, 0.1, 1e-3, 1e-5, 1e-7, 1e-9}) {
    for (const double j3 : {100 - delta, 100 + delta, 110 - delta, 110 + delta}) {
      const ModesResult r = solved(Spacecraft(spin, body(j3)));
      const double rate = spin * std::sqrt(std::abs((j3 - 100) * (j3 - 110)) / (100 * 110));
      const double bound = (1e-14 + 100 * 64 * epsilon / delta) * rate;
      ASSERT_TRUE(r.index_balance.closed) << j3;
      if (j3 > 110) {
        EXPECT_EQ(to_string(r.stability), "stable") << delta;
      } else if (j3 > 100) {
        EXPECT_EQ(to_string(r.stability), "unstable") << delta;
        ASSERT_EQ(r.unstable.size(), 1u);
        EXPECT_NEAR(r.unstable[0].growth_rate, rate, bound) << delta;
        EXPECT_EQ(r.unstable[0].omega, 0);
      } else {
        EXPECT_EQ(to_string(r.stability), "gyroscopically_stabilised") << delta;
        ASSERT_EQ(r.negative_modes.size(), 1u);
        EXPECT_NEAR(r.negative_modes[0].omega, rate, bound) << delta;
      }
    }
  }
}

// Wires stiffen a rotation about axis 1 by Σ aS sin²α, and J₃ passes J₁ − 2aS and J₂ − 2aS with four of them; two along
// axis 1 stiffen the rotation about axis 2 alone.
TEST(SlowMotions, OfABodyWithWires) {
  for (const std::vector<double>& azimuths : {std::vector<double>{0, 90, 180, 270}, {45, 135, 225, 315}, {0, 120, 240}, {0, 180}}) {
    std::vector<Cable> wires;
    double along1 = 0, along2 = 0;
    for (const double degrees : azimuths) {
      wires.push_back({degrees * pi / 180, 0.5, 0, 3, 0.01, 0.1});
      const double stiffening = 0.5 * wires.back().first_moment(), sine = std::sin(degrees * pi / 180);
      along1 += stiffening * sine * sine;
      along2 += stiffening * (1 - sine * sine);
    }
    const double first = 100 - along2, second = 110 - along1;
    for (const double delta : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9}) {
      for (const auto& [j3, expected] : {std::pair(first - delta, "gyroscopically_stabilised"),
                                         {first + delta, "unstable"},
                                         {second - delta, "unstable"},
                                         {second + delta, "stable"}}) {
        const ModesResult r = solved(Spacecraft(1, body(j3), wires));
        EXPECT_EQ(to_string(r.stability), expected) << azimuths.size() << " wires, " << j3 << ", " << delta;
        EXPECT_TRUE(r.index_balance.closed);
      }
    }
  }
}

// Four long wires between the axes and two soft booms, beside the larger value: no approximation by finite elements
// diverges as slowly.
TEST(SlowMotions, OfASatelliteWithBooms) {
  std::vector<Cable> wires;
  for (const double degrees : {45, 135, 225, 315}) wires.push_back({degrees * pi / 180, 0.9, 0.05, 40, 1.1e-3, 0.12});
  const std::vector<Beam> beams{{0.6, true, 6, 0.09, {900, 900}, 0.25}, {-0.6, false, 6, 0.09, {900, 900}, 0.25}};
  const auto at = [&](double j3) { return solved(Spacecraft(pi / 2, {310, Eigen::Vector3d(98, 112, j3).asDiagonal()}, wires, beams)); };
  constexpr double critical = 143.60173720315;
  double slope = 0;
  for (const double j3 : {143.5992, 143.6005, 143.60172, 143.601737}) {
    const ModesResult r = at(j3);
    EXPECT_EQ(to_string(r.stability), "unstable") << j3;
    ASSERT_EQ(r.unstable.size(), 1u) << j3;
    const double growth = r.unstable[0].growth_rate;
    if (slope == 0) slope = growth * growth / (critical - j3);
    EXPECT_NEAR(growth * growth / (critical - j3), slope, 1e-3 * slope) << j3;  // σ² is linear there
  }
  for (const double j3 : {143.601738, 143.6018, 143.603}) EXPECT_EQ(to_string(at(j3).stability), "stable") << j3;
  // J₂ − J₁ = 14 below
  for (const double j3 : {129.60173, 129.601737}) EXPECT_EQ(to_string(at(j3).stability), "gyroscopically_stabilised") << j3;
  for (const double j3 : {129.601738, 129.6018}) EXPECT_EQ(to_string(at(j3).stability), "unstable") << j3;
}

// Any satellites: where n₋ of the static stiffness changes with the body's J₃, found by bisection, a verdict is there
// on both sides, and the slow motion that makes the difference.
TEST(SlowMotions, OfRandomSatellitesBesideTheirCriticalValues) {
  std::size_t borders = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const Spacecraft s = random_spacecraft(seed);
    const auto with = [&](double j3) -> std::optional<Spacecraft> {
      Body b = s.body();
      b.inertia(2, 2) = j3;
      try {
        return Spacecraft(s.spin(), b, s.cables(), s.beams(), s.masses());
      } catch (const LawBroken&) {
        return std::nullopt;  // no such body
      }
    };
    const auto negative = [](const Spacecraft& at) {
      const SpacecraftImpedance impedance(at);
      return static_count(BlockedImpedance(impedance), SpacecraftImpedance::free_coordinates(), SpacecraftImpedance::cyclic_coordinates(),
                          impedance.neutral_patterns())
          .negative;
    };
    const Eigen::Matrix3d j = s.body().inertia;
    double lo = std::abs(j(0, 0) - j(1, 1)) * 1.01 + 1e-3 * j(0, 0), hi = 0.999 * (j(0, 0) + j(1, 1));
    const auto low = with(lo), high = with(hi);
    if (!low || !high || negative(*low) == negative(*high)) continue;
    while (hi - lo > 1e-12 * hi) {
      const double middle = 0.5 * (lo + hi);
      (negative(*with(middle)) == negative(*low) ? lo : hi) = middle;
    }
    ++borders;
    for (const double delta : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8}) {
      for (const double j3 : {lo * (1 - delta), lo * (1 + delta)}) {
        const auto at = with(j3);
        if (!at) continue;
        EXPECT_TRUE(solved(*at).index_balance.closed) << "seed " << seed << ", J3 " << j3 << ", " << delta;
      }
    }
  }
  EXPECT_GE(borders, 8u);
}

}  // namespace
}  // namespace gyromode
