// What a spacecraft promises, each promise broken once.
#include "gyromode/base/error.h"
#include "gyromode/spacecraft/spacecraft.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace gyromode {
namespace {

constexpr double pi = std::numbers::pi;
const Body body{100, Eigen::Vector3d(40, 50, 60).asDiagonal()};
const Cable wire{0, 0.5, 0.2, 20, 0.01, 0.1};

std::vector<Cable> pair(Cable c) {
  Cable opposite = c;
  opposite.azimuth += pi;
  return {c, opposite};
}

template <class Make>
std::string refusal(Make&& make) {
  try {
    make();
  } catch (const LawBroken& e) {
    return e.what();
  }
  return "accepted";
}

std::string with_cable(void (*change)(Cable&)) {
  Cable c = wire;
  change(c);
  return refusal([&] { Spacecraft(1, body, pair(c)); });
}

TEST(SpacecraftPromises, Parts) {
  EXPECT_EQ(refusal([] { Spacecraft(1, body, pair(wire)); }), "accepted");
  EXPECT_EQ(with_cable([](Cable& c) { c.radius = 0; }), "accepted");
  EXPECT_EQ(with_cable([](Cable& c) { c.length = -20; }), "cable 1: 'length' must be above 0: it is -20 m");
  EXPECT_EQ(with_cable([](Cable& c) { c.line_density = 0; }), "cable 1: 'line_density' must be above 0: it is 0 kg/m");
  EXPECT_EQ(with_cable([](Cable& c) { c.tip_mass = -1; }), "cable 1: 'tip_mass' must not be below 0: it is -1 kg");
  EXPECT_EQ(with_cable([](Cable& c) { c.radius = -0.1; }), "cable 1: 'radius' must not be below 0: it is -0.1 m");
  EXPECT_EQ(refusal([] { Spacecraft(0, body, pair(wire)); }), "spin must be above 0: it is 0 rad/s, and without it no cable is taut");
  EXPECT_NE(refusal([] { Spacecraft(-1, body, pair(wire)); }).find("turn axis 3 around"), std::string::npos);
  EXPECT_NE(refusal([] { Spacecraft(1, {-3, body.inertia}); }).find("'mass' must be above 0: it is -3 kg"), std::string::npos);
  EXPECT_NE(refusal([] {
              Spacecraft(1, {100, Eigen::Vector3d(1, 2, 4).asDiagonal()});
            }).find("triangle inequality, no principal moment above the sum of the others: 4 > 1 + 2 kg m²"),
            std::string::npos);
  Eigen::Matrix3d skewed = body.inertia;
  skewed(0, 1) = 3;
  EXPECT_NE(refusal([&] {
              Spacecraft(1, {100, skewed});
            }).find("'inertia' must be symmetric: entries (1,2) = 3 and (2,1) = 0 differ"),
            std::string::npos);
  EXPECT_NE(refusal([] {
              Spacecraft(1, body, {}, {{0, true, 5, 0.1, {10, -1}, 0}});
            }).find("beam 1: 'bending_stiffness' must be above 0: it is -1 N m²"),
            std::string::npos);
  const double rigid = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal([&] {
              Spacecraft(1, body, {}, {}, {{{0.4, 0, 0}, 2, {0, 5, rigid}}});
            }).find("'stiffness' must be above 0 (inf: rigid), or nothing holds the mass to the body: along axis 1 it is 0 N/m"),
            std::string::npos);
}

// Numbers that are in range one by one, and whose moments are not.
TEST(SpacecraftPromises, Range) {
  for (const double length : {1e110, 1e200, 1e300}) {
    const std::string wires = refusal([length] { Spacecraft(1, body, pair({0, 0.5, 0.2, length, 1e90, 0.1})); });
    EXPECT_NE(wires.find("cable 1: mass "), std::string::npos) << wires;
    EXPECT_NE(wires.find("leave the range of numbers"), std::string::npos) << wires;
    EXPECT_NE(refusal([length] {
                Spacecraft(1, body, {}, {{0, true, length, 1e90, {10, 10}, 0}});
              }).find("beam 1: mass "),
              std::string::npos);
    EXPECT_NE(refusal([length] {
                Spacecraft(1, body, {}, {}, {{{0, 0, length}, 1e90, {5, 5, 5}}});
              }).find("spring mass 1: mass "),
              std::string::npos);
  }
  EXPECT_NE(refusal([] { Spacecraft(1e-170, body); }).find("leave the range of numbers"), std::string::npos);
  EXPECT_NE(refusal([] { Spacecraft(1e160, body); }).find("leave the range of numbers"), std::string::npos);
  EXPECT_EQ(refusal([] { Spacecraft(1e-100, body, pair({0, 0.5, 0.2, 20, 1e-60, 0.1})); }), "accepted");
}

// By how much, in newtons and newton metres: S = ∫ r dm = 0.1·20.5 + 0.01·20·10.5 = 4.15 kg m.
TEST(SpacecraftPromises, Equilibrium) {
  const std::string force = refusal([] { Spacecraft(2, body, {wire}); });
  EXPECT_NE(force.find("which leaves a centrifugal force of (16.6, 0) N"), std::string::npos) << force;
  Cable opposite = wire;
  opposite.azimuth = pi;
  opposite.height = -0.2;
  const std::string moment = refusal([&] { Spacecraft(2, body, {wire, opposite}); });
  EXPECT_NE(moment.find("J13 = -1.66, J23 = 0 kg m², which leaves a moment of (0, 6.64) N m"), std::string::npos) << moment;
  // The body's own product of inertia balances it.
  Body balanced = body;
  balanced.inertia(0, 2) = balanced.inertia(2, 0) = 1.66;
  EXPECT_EQ(refusal([&] { Spacecraft(2, balanced, {wire, opposite}); }), "accepted");
  // Rounded azimuths pass.
  opposite = wire;
  opposite.azimuth = 3.1415926536;
  EXPECT_EQ(refusal([&] { Spacecraft(2, body, {wire, opposite}); }), "accepted");
}

TEST(SpacecraftPromises, TheCentreOfMassIsThatOfTheWhole) {
  const Spacecraft s(1, body, pair(wire), {{0.5, true, 4, 0.1, {10, 10}, 0.2}});
  const double mass = 100 + 2 * 0.3 + 0.6, moment = 2 * 0.3 * 0.2 + 0.4 * 2.5 + 0.2 * 4.5;
  EXPECT_NEAR(s.rigid().mass, mass, 1e-12);
  EXPECT_NEAR(s.centre(), moment / mass, 1e-15);
  EXPECT_NEAR(s.rigid().first.norm(), 0, 1e-12);
}

}  // namespace
}  // namespace gyromode
