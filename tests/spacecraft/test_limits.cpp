// Where booms degenerate: no radius, no tip mass, equal stiffnesses, equal booms; high frequencies; modes at poles and
// pairs that nearly coincide. None is lost, none loses digits.
#include "gyromode/appendage/hub_impedance.h"
#include "gyromode/modes/effective_axes.h"
#include "gyromode/modes/spacecraft_spectrum.h"
#include "gyromode/modes/spacecraft.h"
#include "gyromode/spacecraft/clamped_booms.h"
#include "gyromode/appendage/cable.h"
#include "gyromode/appendage/beam.h"
#include "gyromode/appendage/spring_mass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace gyromode {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double spin = 0.8;

std::vector<Cable> ring(int wires, double radius, double height, double tip_mass, double turn = 0) {
  std::vector<Cable> all;
  for (int k = 0; k < wires; ++k) all.push_back({turn + 2 * pi * k / wires, radius, height, 20, 0.01, tip_mass});
  return all;
}

const Body body{300, Eigen::Vector3d(100, 120, 180).asDiagonal()};

std::vector<Mode> modes(const Spacecraft& s, double below) {
  ModesOptions options;
  options.window.b = below * s.spin();
  const ModesResult r = find_modes(s, options);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << r.coverage.reason;
  return r.modes;
}

std::vector<double> locals(const std::vector<Mode>& all) {
  std::vector<double> omega;
  for (const Mode& m : all) {
    if (m.kind == ModeKind::local) omega.push_back(m.omega);
  }
  return omega;
}

// Wires hinged on the axis: patterns that leave the body at rest have the closed-form frequencies Ω√(n(2n − 1)) out of
// plane and Ω√(n(2n − 1) − 1) in plane, degrees ν = 2n − 1 up to 300.
TEST(Limits, WiresOnTheAxisToDegreeThreeHundred) {
  const Spacecraft s(spin, body, ring(4, 0, 0, 0));
  const std::vector<Mode> all = modes(s, 212);
  std::vector<double> expected;
  for (int n = 1; n <= 150; ++n) {
    const double square = n * (2.0 * n - 1);
    if (n > 1) {
      for (int twice = 0; twice < 2; ++twice) expected.push_back(spin * std::sqrt(square - 1));
    }
    for (int thrice = 0; thrice < 3; ++thrice) expected.push_back(spin * std::sqrt(square));
  }
  while (!expected.empty() && expected.back() >= 212 * spin) expected.pop_back();
  std::sort(expected.begin(), expected.end());
  const std::vector<double> found = locals(all);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-13 * expected[i]) << i;
  // Zero modes: spin, axial translation, and the two patterns that turn about the axis and leave the mass centre at
  // rest.
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const Mode& m) { return m.omega == 0; }), 4);
}

// Frequencies for a vanishing radius go to those for none, by O(radius), and the pendulum in plane to Ω√(3a/2L).
TEST(Limits, RadiusToZero) {
  const auto omegas = [](double radius) {
    std::vector<double> all;
    for (const Mode& m : modes(Spacecraft(spin, body, ring(4, radius, 0, 0)), 6)) {
      if (m.omega > 0.01 * spin) all.push_back(m.omega);
    }
    return all;
  };
  const std::vector<double> none = omegas(0);
  for (const double radius : {1e-6, 1e-9, 1e-12}) {
    const std::vector<double> some = omegas(radius);
    ASSERT_EQ(some.size(), none.size()) << radius;
    for (std::size_t i = 0; i < some.size(); ++i) EXPECT_NEAR(some[i], none[i], 2 * radius * spin + 2e-13 * none[i]) << radius << " " << i;
    const std::vector<double> pendulum = locals(modes(Spacecraft(spin, body, ring(4, radius, 0, 0)), 0.1));
    ASSERT_EQ(pendulum.size(), 1u);
    EXPECT_NEAR(pendulum[0] / (spin * std::sqrt(1.5 * radius / 20)), 1, 2 * radius / 20 + 1e-13);
  }
}

TEST(Limits, TipMassToZero) {
  const std::vector<Mode> none = modes(Spacecraft(spin, body, ring(2, 0.5, 0.1, 0)), 20);
  for (const double tip : {1e-12, 1e-16, 1e-25}) {
    const std::vector<Mode> some = modes(Spacecraft(spin, body, ring(2, 0.5, 0.1, tip)), 20);
    ASSERT_EQ(some.size(), none.size());
    for (std::size_t i = 0; i < some.size(); ++i)
      EXPECT_NEAR(some[i].omega, none[i].omega, (1e5 * tip + 3e-14) * none[i].omega) << tip << " " << i;
  }
}

TEST(Limits, EqualBendingStiffnesses) {
  const auto with = [](double ratio) {
    return modes(Spacecraft(spin, body, ring(2, 0.5, 0.1, 0.02, 0.5 * pi), {{0.4, true, 6, 0.1, {30, 30 * ratio}, 0.2}}), 30);
  };
  const std::vector<Mode> equal = with(1);
  for (const double off : {1e-15, 1e-12, 1e-9}) {
    const std::vector<Mode> nearly = with(1 + off);
    ASSERT_EQ(nearly.size(), equal.size());
    for (std::size_t i = 0; i < equal.size(); ++i) EXPECT_NEAR(nearly[i].omega, equal[i].omega, (2 * off + 5e-13) * equal[i].omega) << off;
  }
}

// Two rings, detuned by 1e-9: patterns apart from the body come in pairs 1e-9 or less apart. Both of each pair are
// there, told apart.
TEST(Limits, PairsATrillionthApart) {
  for (const double off : {1e-6, 1e-9, 1e-12}) {
    std::vector<Cable> wires = ring(4, 0.5, 0, 0.05);
    std::vector<Cable> others = ring(4, 0.5, 0, 0.05, 0.25 * pi);
    for (Cable& c : others) c.length *= 1 + off;
    wires.insert(wires.end(), others.begin(), others.end());
    const std::vector<Mode> all = modes(Spacecraft(spin, body, wires), 5);
    // Equal wires would be one group of eight; local patterns there: five in plane and five out of plane at each
    // frequency.
    const std::vector<Mode> equal = modes(Spacecraft(spin, body, ring(8, 0.5, 0, 0.05)), 5);
    ASSERT_EQ(all.size(), equal.size()) << off;
    for (std::size_t i = 0; i < all.size(); ++i)
      EXPECT_NEAR(all[i].omega, equal[i].omega, (4 * off + 1e-13) * equal[i].omega) << off << " " << i;
    std::size_t apart = 0;
    for (std::size_t i = 1; i < all.size(); ++i) {
      const double distance = all[i].omega / all[i - 1].omega - 1;
      if (all[i - 1].omega > 0 && distance > 0 && distance < 3 * off) ++apart;
    }
    EXPECT_GE(apart, off > 1e-11 ? 4u : 0u) << off;
  }
}

// A heavy body hardly moves: modes are beside the poles of the wires, to within rounding of each other, and still one
// for each.
TEST(Limits, ModesAtPoles) {
  for (const double weight : {1e3, 1e6, 1e9, 1e12}) {
    const Body heavy{300 * weight, weight * Eigen::Vector3d(100, 120, 180).asDiagonal()};
    const Spacecraft s(spin, heavy, ring(2, 0.5, 0, 0.05));
    const std::vector<Mode> all = modes(s, 10);
    const CableGroup alone(ring(2, 0.5, 0, 0.05), spin);
    // Spin, axial translation, nutation and tilt besides.
    EXPECT_EQ(static_cast<Index>(all.size()), fixed_root_negative(alone, 10 * spin) + 4) << weight;
  }
}

// Rigid body alone: nutation Ω√((J33 − J11)(J33 − J22)/(J11 J22)), of negative energy for the least inertia, divergent
// for the middle one.
TEST(Limits, RigidBody) {
  const auto result = [](double a, double b, double c) {
    ModesOptions options;
    options.window.b = 3 * spin;
    return find_modes(Spacecraft(spin, {10, Eigen::Vector3d(a, b, c).asDiagonal()}), options);
  };
  const ModesResult largest = result(4, 5, 6);
  ASSERT_EQ(largest.modes.size(), 4u);
  EXPECT_NEAR(largest.modes[2].omega, spin * std::sqrt(2.0 * 1 / 20), 1e-14);
  EXPECT_EQ(largest.modes[3].kind, ModeKind::rigid_body);
  EXPECT_EQ(largest.modes[3].omega, spin);
  EXPECT_EQ(largest.stability, Stability::stable);
  const ModesResult least = result(6, 5, 4);
  EXPECT_NEAR(least.modes[2].omega, spin * std::sqrt(2.0 * 1 / 30), 1e-14);
  EXPECT_EQ(least.modes[2].energy_sign, -1);
  EXPECT_EQ(least.stability, Stability::gyroscopically_stabilised);
  EXPECT_EQ(least.coverage.status, CoverageStatus::complete);
  EXPECT_EQ(least.index_balance.negative, 2);
  const ModesResult middle = result(4, 6, 5);
  EXPECT_EQ(middle.stability, Stability::unstable);
  ASSERT_EQ(middle.unstable.size(), 1u);
  EXPECT_NEAR(middle.unstable[0].growth_rate, spin * std::sqrt(1.0 * 1 / 24), 1e-13);
  EXPECT_EQ(middle.unstable[0].omega, 0);
  EXPECT_EQ(middle.coverage.status, CoverageStatus::complete);
  for (const double b : {4.1, 5.0, 5.9, 5.999, 5.99999}) {  // of inertias 4, 6, b: ever slower
    const ModesResult r = result(4, 6, b);
    ASSERT_EQ(r.unstable.size(), 1u) << b;
    const double truth = spin * std::sqrt((6 - b) * (b - 4) / 24), epsilon = std::numeric_limits<double>::epsilon();
    EXPECT_LE(std::abs(r.unstable[0].growth_rate - truth), r.unstable[0].error_bound + 4 * epsilon * truth) << b;
    EXPECT_LE(r.unstable[0].error_bound, 1e-13 * spin * spin / truth) << b;
    EXPECT_LE(r.unstable[0].residual, 1e-8) << b;
  }
}

// Booms on a body that only spins: wires on the axis by their closed form, an axisymmetric boom at its cantilever
// frequencies ± Ω, a mass on springs at √(k/m) ± Ω.
TEST(Limits, HeldBooms) {
  std::vector<Cable> wires = ring(2, 0, 0.1, 0);
  const double l = 6, density = 0.1, stiffness = 30;
  const Spacecraft s(spin, body, wires, {{0.4, true, l, density, {stiffness, stiffness}, 0}},
                     {{{0, 0, 1}, 2, {50, 50, std::numeric_limits<double>::infinity()}}});
  const std::vector<ClampedBoom> booms = clamped_booms(s, 4);
  ASSERT_EQ(booms.size(), 4u);
  EXPECT_EQ(booms[0].name, "cables 1, 2, in plane");
  for (std::size_t n = 1; n <= 4; ++n) {
    const double m = static_cast<double>(n);
    EXPECT_NEAR(booms[1].frequencies[n - 1], spin * std::sqrt(m * (2 * m - 1)), 1e-13) << n;
  }
  for (std::size_t n = 2; n <= 4; ++n) {
    const double m = static_cast<double>(n);
    EXPECT_NEAR(booms[0].frequencies[n - 1 - (booms[0].frequencies[0] > 0.1 ? 1 : 0)], spin * std::sqrt(m * (2 * m - 1) - 1), 1e-13) << n;
  }
  const double first = std::pow(1.8751040687119611 / l, 2) * std::sqrt(stiffness / density),
               second = std::pow(4.6940911329741746 / l, 2) * std::sqrt(stiffness / density);
  ASSERT_EQ(booms[2].frequencies.size(), 4u);
  EXPECT_NEAR(booms[2].frequencies[0], first - spin, 1e-12);
  EXPECT_NEAR(booms[2].frequencies[1], first + spin, 1e-12);
  EXPECT_NEAR(booms[2].frequencies[2], second - spin, 1e-11);
  EXPECT_NEAR(booms[2].frequencies[3], second + spin, 1e-11);
  ASSERT_EQ(booms[3].frequencies.size(), 2u);
  EXPECT_NEAR(booms[3].frequencies[0], 5 - spin, 1e-13);
  EXPECT_NEAR(booms[3].frequencies[1], 5 + spin, 1e-13);
}

// Wires turned from the principal axes: ψ of the effective inertia, tan 2ψ = 2 g1 e1 e2/(I1 − I2 + g1(e1² − e2²)), with
// e = (−sin α, cos α) and g1 from the pair by itself (docs/booms.md (B13)).
TEST(Limits, EffectiveAxesOfRotatedWires) {
  const double alpha = 115 * pi / 180;
  const std::vector<Cable> wires = ring(2, 0.8, 0, 0, alpha);
  const Spacecraft s(spin, body, wires);
  const CableGroup pair(wires, spin);
  const std::vector<EffectiveAxes> axes = effective_axes(SpacecraftSpectrum(s), 8);
  ASSERT_GE(axes.size(), 9u);
  for (const EffectiveAxes& a : axes) {
    if (std::abs(a.omega - spin) < 1e-9) continue;
    // g1(Ω² − ω²) is the entry of the pair on rotation about e.
    const HubMatrix h = hub_impedance(pair, a.omega, spin);
    const Eigen::Vector2d e(-std::sin(alpha), std::cos(alpha));
    const Eigen::Matrix2d tilt = h.block<2, 2>(3, 3).real();
    const double g1 = e.dot(tilt * e) / (spin * spin - a.omega * a.omega);
    const double expected =
        0.5 * std::atan2(2 * g1 * e(0) * e(1), body.inertia(0, 0) - body.inertia(1, 1) + g1 * (e(0) * e(0) - e(1) * e(1)));
    EXPECT_NEAR(std::remainder(a.angle - expected, 0.5 * pi), 0, 1e-9) << a.omega / spin;
    EXPECT_LE(std::abs(a.angle), 0.25 * pi + 1e-15);
  }
  EXPECT_TRUE(effective_axes(SpacecraftSpectrum(Spacecraft(spin, body, ring(2, 0.8, 0, 0, 0.5 * pi))), 8).empty());
}

}  // namespace
}  // namespace gyromode
