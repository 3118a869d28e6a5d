// Cases that a hostile reader found: brackets that end on another root, stiff and light springs, windows that end on a
// mode, counts at the poles of beams, shapes at the spin itself.
#include "gyromode/base/error.h"
#include "gyromode/modes/discrete.h"
#include "gyromode/modes/spacecraft.h"
#include "gyromode/spacecraft/clamped_booms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gyromode {
namespace {

constexpr double pi = std::numbers::pi;
const Body body{100, Eigen::Vector3d(90, 110, 150).asDiagonal()};

ModesResult below(const Spacecraft& s, double omega) {
  ModesOptions options;
  options.window.b = omega;
  return find_modes(s, options);
}

// In one block a pattern of the wires on the axis has the eigenvalue 0 at ω = 0, where the bracket of the next root
// begins.
TEST(HardCases, WiresOnTheAxisBesideWiresOffIt) {
  const Spacecraft s(1, body,
                     {{0.5 * pi, 0, 0, 20, 0.01, 0}, {1.5 * pi, 0, 0, 20, 0.01, 0}, {0, 1e-3, 0, 20, 0.01, 0}, {pi, 1e-3, 0, 20, 0.01, 0}});
  const ModesResult r = below(s, 0.03);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
  ASSERT_EQ(r.modes.size(), 4u);
  EXPECT_NEAR(r.modes[3].omega, 0.0100831739831491, 1e-15);
  EXPECT_EQ(r.modes[3].energy_sign, 1);
  EXPECT_TRUE(std::isfinite(r.modes[3].residual));
}

// As a spring grows stiff the satellite becomes the one with the mass welded on; a spin of any size.
TEST(HardCases, StiffSpringsAreWelds) {
  const double rigid = std::numeric_limits<double>::infinity();
  for (const double spin : {1e-7, 0.01, 0.5}) {
    const auto with = [&](double k) { return Spacecraft(spin, body, {}, {}, {{{0, 0, 0.5}, 1, {k, k, k}}}); };
    ModesOptions all;
    const ModesResult welded = find_modes(with(rigid), all);
    for (const double k : {1e6, 1e9, 1e12}) {
      const ModesResult r = find_modes(with(k), all);
      EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
      EXPECT_EQ(r.index_balance.negative, 0);
      ASSERT_EQ(r.modes.size(), 7u);
      EXPECT_NEAR(r.modes[2].omega, welded.modes[2].omega, (2 * spin * spin / k + 1e-14) * spin);
      EXPECT_EQ(r.modes[3].omega, spin);
      EXPECT_EQ(r.modes[3].kind, ModeKind::rigid_body);
      // Free against the rest of the body: reduced mass 1/(1 + 1/100).
      EXPECT_NEAR(r.modes[4].omega / std::sqrt(1.01 * k), 1, spin / std::sqrt(k) + 1e-14);
    }
  }
}

TEST(HardCases, LightMassesWeighAsMuch) {
  for (const double mass : {1e-3, 1e-8, 1e-14}) {
    const ModesResult r = find_modes(Spacecraft(1, body, {}, {}, {{{0, 0, 0.5}, mass, {20 * mass, 30 * mass, 40 * mass}}}), {});
    EXPECT_EQ(r.stability, Stability::stable);
    EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
    ASSERT_EQ(r.modes.size(), 7u);
    EXPECT_NEAR(r.modes[5].omega / std::sqrt(40), 1, mass + 0.2);
  }
}

// The end of a window on a mode moves out, and the count is certified there; count and modes agree.
TEST(HardCases, WindowsThatEndOnAMode) {
  const Spacecraft s(0.9, body, {{0.5 * pi, 0.5, 0.1, 20, 0.02, 0.1}, {1.5 * pi, 0.5, 0.1, 20, 0.02, 0.1}});
  const ModesResult all = below(s, 9);
  for (const Mode& m : all.modes) {
    if (m.omega == 0) continue;
    for (const double end :
         {m.omega, std::nextafter(m.omega, 0), std::nextafter(m.omega, 10), m.omega * (1 + 1e-15), m.omega * (1 - 3e-15)}) {
      const ModesResult upto = below(s, end);
      EXPECT_EQ(upto.coverage.status, CoverageStatus::complete) << upto.coverage.reason;
      const CountResult count = count_modes(s, {0, end});
      EXPECT_EQ(count.status, CountStatus::exact);
      EXPECT_EQ(count.count, upto.coverage.found);
      EXPECT_EQ(count.window.b, upto.coverage.window.b);
      const CountResult from = count_modes(s, {end, 9});
      EXPECT_EQ(from.status, CountStatus::exact);
    }
  }
}

// At the fixed-root frequencies of a boom, and an ulp beside them, the count is that of its neighbourhood.
TEST(HardCases, CountsAtThePolesOfABeam) {
  const Spacecraft s(1, body, {}, {{0.5, true, 7.5, 0.12, {300, 300}, 0}});
  for (const ClampedBoom& boom : clamped_booms(s, 6)) {
    for (const double pole : boom.frequencies) {
      const CountResult around = count_modes(s, {0, pole * (1 - 1e-9)}), beyond = count_modes(s, {0, pole * (1 + 1e-9)});
      for (int ulps = -4; ulps <= 4; ++ulps) {
        const CountResult at = count_modes(s, {0, pole * (1 + ulps * 1.1e-16)});
        EXPECT_TRUE(at.count == around.count || at.count == beyond.count) << pole;
      }
      EXPECT_EQ(around.count, beyond.count) << "a pole is no mode, " << pole;
    }
  }
}

// A lamina: nutation and tilt coincide at the spin, where B is singular.
TEST(HardCases, ShapesAtTheSpin) {
  ModesOptions options;
  options.shapes = true;
  const ModesResult r = find_modes(Spacecraft(1, {100, Eigen::Vector3d(90, 110, 200).asDiagonal()}), options);
  ASSERT_EQ(r.modes.size(), 4u);
  for (const Mode& m : r.modes) {
    EXPECT_TRUE(m.shape.allFinite());
    EXPECT_NEAR(m.shape.cwiseAbs().maxCoeff(), 1, 1e-15);
  }
  EXPECT_EQ(r.modes[2].omega, 1);
  EXPECT_NEAR(r.modes[3].omega, 1, 1e-14);
}

TEST(HardCases, DiscreteListsWhatExactLists) {
  const Spacecraft s(0.9, body, {{0.5 * pi, 1, 0.1, 20, 0.02, 0}, {1.5 * pi, 1, 0.1, 20, 0.02, 0}});
  for (const Index lowest : {1, 3, 4, 6}) {
    ModesOptions options;
    options.lowest = lowest;
    const ModesResult exact = find_modes(s, options), discrete = find_modes(s, Mesh{2, 12}, options);
    ASSERT_EQ(exact.modes.size(), discrete.modes.size()) << lowest;
    for (std::size_t i = 0; i < exact.modes.size(); ++i) {
      EXPECT_NEAR(exact.modes[i].omega, discrete.modes[i].omega, 1e-9);
      EXPECT_EQ(exact.modes[i].kind, discrete.modes[i].kind);
    }
    EXPECT_EQ(exact.stability, discrete.stability);
  }
}

// The middle of the window is a mode of negative energy, and one of positive energy is beside it: on it the count is
// one of two, and each root has to stay where it is.
TEST(HardCases, WindowsAroundAModeOfNegativeEnergy) {
  constexpr double rigid = std::numeric_limits<double>::infinity();
  for (const double spin : {4.905717, 4.905718, 4.90572, 4.905722, 4.90573, 4.906, 4.91}) {
    const Spacecraft s(spin, {100, Eigen::Vector3d(100, 110, 150).asDiagonal()}, {}, {},
                       {{{0, 0, 0.5}, 2, {8, 20, 50}}, {{0.6, 0, 0}, 1, {8, 20, rigid}}, {{-0.6, 0, 0}, 1, {8, 20, rigid}}});
    ModesOptions options;
    options.window = {0.1, 3};
    const ModesResult all = find_modes(s, options);
    ASSERT_EQ(all.modes.size(), 4u);
    EXPECT_EQ(to_string(all.stability), "gyroscopically_stabilised");
    EXPECT_NEAR(all.opposite_gap, 1 - all.modes[2].omega / all.modes[3].omega, 1e-11) << spin;
    for (const Mode& m : all.negative_modes) {
      for (const double around : {0.5, 0.25, 0.1}) {
        options.window = {(1 - around) * m.omega, (1 + around) * m.omega};
        const ModesResult some = find_modes(s, options);
        EXPECT_EQ(some.coverage.status, CoverageStatus::complete) << some.coverage.reason;
        std::size_t expected = 0;
        for (const Mode& other : all.modes) expected += options.window.contains(other.omega) ? 1 : 0;
        ASSERT_EQ(some.modes.size(), expected);
        for (const Mode& found : some.modes) {
          EXPECT_TRUE(std::any_of(
              all.modes.begin(), all.modes.end(),
              [&](const Mode& o) { return o.energy_sign == found.energy_sign && std::abs(o.omega - found.omega) <= 1e-11 * o.omega; }))
              << spin << ", " << found.omega;
        }
      }
    }
  }
}

TEST(HardCases, BeyondReach) {
  const Spacecraft s(1, body, {{0, 1, 0, 20, 0.02, 0}, {pi, 1, 0, 20, 0.02, 0}});
  EXPECT_THROW(below(s, 1e9), InvalidArgument);
  EXPECT_THROW(count_modes(s, {0, 1e300}), InvalidArgument);
}

}  // namespace
}  // namespace gyromode
