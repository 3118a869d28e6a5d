// The response to unbalance: closed forms, a dense solution of every speed, and what is invariant.
#include "gyromode/base/error.h"
#include "gyromode/models/model.h"
#include "gyromode/models/rotor_model.h"
#include "gyromode/read/read_model.h"
#include "support/random_rotor.h"

#include <Eigen/LU>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <random>

namespace gyromode {
namespace {

// A mass on springs kx, ky, in axes that turn with it or not: M, G₁, K₀, K₂ of order 2.
Model jeffcott(double m, double kx, double ky, bool turning) {
  const std::string text = fmt::format(
      "kind = \"matrices\"\nlabels = [\"x\", \"y\"]\norbits = [[\"x\", \"y\"]]\nframe = \"{}\"\nspin = 1\nmass = [[{}, 0], [0, {}]]\n"
      "stiffness = [[{}, 0], [0, {}]]\ngyroscopic_per_spin = [[0, {}], [{}, 0]]\nstiffness_per_spin2 = [[{}, 0], [0, {}]]\n",
      turning ? "turning" : "fixed", m, m, kx, ky, turning ? -2 * m : 0.0, turning ? 2 * m : 0.0, turning ? -m : 0.0, turning ? -m : 0.0);
  return parse_model(text, "jeffcott.toml");
}

UnbalanceReport answered(const Model& model, std::vector<Unbalance> masses, const Vector& speeds) {
  return model.unbalance_response({std::move(masses), speeds, {}});
}

// q = UΩ²/(k − mΩ²), going round with the speed; at rest in axes that turn with it.
TEST(Unbalance, JeffcottRotor) {
  const double m = 3, k = 48, u = 1e-3, phase = 0.3;
  for (const bool turning : {false, true}) {
    const UnbalanceReport r = answered(jeffcott(m, k, k, turning), {{"x", u, phase}}, Vector::LinSpaced(9, 0, 8));
    for (const SynchronousPoint& p : r.response.points) {
      if (std::abs(p.speed - 4) < 1e-9) {
        EXPECT_TRUE(p.resonance());
        continue;
      }
      const double size = u * p.speed * p.speed / (k - m * p.speed * p.speed);
      const double near = 1e-13 * std::abs(size) * (1 + 16 / std::abs(16 - p.speed * p.speed));
      const Complex x = turning ? Complex(size * std::cos(phase)) : size * std::polar(1.0, phase);
      const Complex y = turning ? Complex(size * std::sin(phase)) : Complex(0, -1) * x;
      EXPECT_LE(std::abs(p.q(0) - x), near) << p.speed;
      EXPECT_LE(std::abs(p.q(1) - y), near) << p.speed;
      EXPECT_NEAR(r.orbit(p, 0).major, std::abs(size), near);
      EXPECT_NEAR(r.orbit(p, 0).minor, std::abs(size), near);
    }
    ASSERT_FALSE(r.response.resonances().empty());
    EXPECT_NEAR(r.response.resonances().front(), 4, 1e-12);
  }
}

// A shaft of unequal stiffness, its mass out of balance along one of the axes: that threshold alone is driven, and the
// other has the limit.
TEST(Unbalance, ShaftOfUnequalStiffness) {
  Vector speeds(4);
  speeds << 10, 20, 25, 30;
  const UnbalanceReport r = answered(jeffcott(1, 900, 400, true), {{"x", 1e-3, 0}}, speeds);
  ASSERT_EQ(r.response.resonances().size(), 1u);
  EXPECT_NEAR(r.response.resonances()[0], 30, 1e-11);
  for (const SynchronousPoint& p : r.response.points) {
    if (p.added || p.resonance()) continue;
    EXPECT_NEAR(p.q(0).real(), 1e-3 * p.speed * p.speed / (900 - p.speed * p.speed), 1e-13);
    EXPECT_NEAR(std::abs(p.q(1)), 0, 1e-13);
    EXPECT_NEAR(r.orbit(p, 0).major, std::abs(p.q(0)), 1e-15);
  }
}

// A shaft that turns r times as fast has the unbalance U(rΩ)²: what it does at Ω is what a rotor of its own does at rΩ.
TEST(Unbalance, GoesWithTheSpeedOfItsOwnShaft) {
  const auto rotor = [](double ratio) {
    return parse_model(fmt::format(R"(kind = "rotor"
speed = 10
[material.steel]
young = 2e11
shear = 8e10
density = 7800
[spool.a]
speed_ratio = {}
[[shaft]]
spool = "a"
length = 1
outer_diameter = 0.05
elements = 4
material = "steel"
[[disk]]
spool = "a"
position = 0.25
mass = 5
polar_inertia = 0.1
diametral_inertia = 0.06
[[bearing]]
spool = "a"
position = 0
kxx = 1e6
kyy = 2e6
[[bearing]]
spool = "a"
position = 1
kxx = 1e6
kyy = 2e6
)",
                                   ratio),
                       "spool.toml");
  };
  const ComplexVector fast = answered(rotor(2), {{"disk1", 1e-3, 0.2}}, Vector::Constant(1, 100)).response.points[0].q,
                      own = answered(rotor(1), {{"disk1", 1e-3, 0.2}}, Vector::Constant(1, 200)).response.points[0].q;
  EXPECT_LE((fast - own).norm(), 1e-12 * own.norm());
  EXPECT_THROW(answered(rotor(0), {{"disk1", 1e-3, 0}}, Vector::Constant(1, 100)), InvalidArgument);
}

// On springs that differ, in fixed axes: each direction by itself; both critical speeds are driven.
TEST(Unbalance, OrthotropicJeffcottRotor) {
  const UnbalanceReport r = answered(jeffcott(2, 32, 50, false), {{"x", 1, 0}}, Vector::LinSpaced(8, 0.5, 7.5));
  for (const SynchronousPoint& p : r.response.points) {
    const double s2 = p.speed * p.speed;
    if (p.added) continue;
    EXPECT_NEAR(p.q(0).real(), s2 / (32 - 2 * s2), 1e-12 * std::abs(s2 / (32 - 2 * s2)));
    EXPECT_NEAR(p.q(1).imag(), -s2 / (50 - 2 * s2), 1e-12 * std::abs(s2 / (50 - 2 * s2)));
  }
  EXPECT_EQ(r.response.resonances().size(), 2u);
}

// A free rigid mass moves against its unbalance at any speed: q = −U/m, at rest too.
TEST(Unbalance, FreeMass) {
  const UnbalanceReport r = answered(jeffcott(4, 0, 0, false), {{"x", 2, 0}}, Vector::LinSpaced(5, 0, 4));
  for (const SynchronousPoint& p : r.response.points) EXPECT_NEAR(p.q(0).real(), -0.5, 1e-12) << p.speed;
}

// Axes that turn change nothing: a chain of three masses, seen from them.
TEST(Unbalance, ChainFromTurningAxes) {
  std::string text(R"(kind = "matrices"
frame = "turning"
labels = ["x1", "x2", "y1", "y2"]
orbits = [["x1", "y1"], ["x2", "y2"]]
spin = 1.0
mass = [1, 2, 1, 2]
gyroscopic_per_spin = [[0, 0, -2, 0], [0, 0, 0, -4], [2, 0, 0, 0], [0, 4, 0, 0]]
stiffness = [[3, -1, 0, 0], [-1, 5, 0, 0], [0, 0, 3, -1], [0, 0, -1, 5]]
stiffness_per_spin2 = [-1, -2, -1, -2]
)");
  const Model model = parse_model(text, "chain.toml");
  const UnbalanceReport r = answered(model, {{"x2", 1, 0}}, Vector::LinSpaced(6, 0.25, 3));
  EXPECT_EQ(r.response.order, 0);
  for (const SynchronousPoint& p : r.response.points) {
    if (p.added) continue;
    Eigen::Matrix2d h;
    h << 3 - p.speed * p.speed, -1, -1, 5 - 2 * p.speed * p.speed;
    const Eigen::Vector2d x = h.inverse() * Eigen::Vector2d(0, p.speed * p.speed);
    EXPECT_NEAR(p.q(0).real(), x(0), 1e-11 * x.norm());
    EXPECT_NEAR(p.q(1).real(), x(1), 1e-11 * x.norm());
    EXPECT_NEAR(p.q.tail(2).norm(), 0, 1e-11 * x.norm());
    EXPECT_NEAR(r.orbit(p, 1).major, std::abs(x(1)), 1e-11 * x.norm());
  }
}

// Seeded rotors against LU of H(Ω), and in other units.
TEST(Unbalance, SeededRotorsAgainstLU) {
  const char* count = std::getenv("GYROMODE_UNBALANCES");
  const int draws = count ? std::atoi(count) : 30;
  support::Source source{std::mt19937_64(17)};
  for (int draw = 0; draw < draws; ++draw) {
    const Rotor rotor(support::random_rotor(source));
    const Model model(std::make_shared<RotorModel>(rotor));
    const std::vector<Unbalance> masses{{"station2", 1e-3, 0.4}, {"station1", 2e-4, -2}};
    Model fixed = model;
    fixed.frame = Frame::fixed;
    UnbalanceReport r;
    try {
      r = answered(fixed, masses, Vector::LinSpaced(7, 13, 1900));
    } catch (const InvalidArgument&) {
      continue;  // stations that are held, or of shafts of different speed
    }
    const SpinFamily family = assembled(rotor);
    const ComplexVector f = model.body->unbalance(masses).per_speed2;
    for (const SynchronousPoint& p : r.response.points) {
      if (p.resonance()) continue;
      const double omega = r.response.order * p.speed;
      const ComplexMatrix h = (family.stiffness - omega * omega * family.mass).cast<Complex>() +
                              Complex(0, omega * p.speed) * family.gyroscopic_per_spin.cast<Complex>();
      const ComplexVector right = p.speed * p.speed * f;
      const ComplexVector used = r.speed_ratio < 0 ? right.conjugate().eval() : right;
      const double terms =
          h.cwiseAbs().rowwise().sum().cwiseProduct(p.q.cwiseAbs()).maxCoeff() + (h.cwiseAbs() * p.q.cwiseAbs()).maxCoeff();
      EXPECT_LE((h * p.q - used).cwiseAbs().maxCoeff(), 1e-12 * (terms + used.cwiseAbs().maxCoeff())) << draw << " at " << p.speed;
    }
  }
}

// Forward whirl alone is driven on isotropic bearings, all critical speeds on others.
TEST(Unbalance, BackwardWhirlIsNotDrivenOnIsotropicBearings) {
  const std::filesystem::path rotors = std::filesystem::path(GYROMODE_SOURCE_DIR) / "models" / "rotors";
  for (const bool isotropic : {true, false}) {
    const Model model = read_model(rotors / (isotropic ? "two_discs.toml" : "two_discs_orthotropic.toml"));
    const CriticalSpeeds critical = model.critical_speeds();
    const UnbalanceReport r = answered(model, {{"disk1", 1e-4, 0}, {"disk2", 3e-4, 1}}, Vector::LinSpaced(3, 1, 2000));
    ASSERT_GE(r.response.critical.size(), 6u);
    for (std::size_t k = 0; k < r.response.critical.size(); ++k) {
      const DrivenMode& m = r.response.critical[k];
      EXPECT_NEAR(m.omega, critical.speeds[k].speed, 1e-9 * m.omega);
      EXPECT_EQ(m.driven == Driven::yes, !isotropic || critical.speeds[k].whirl == Whirl::forward) << isotropic << " " << m.omega;
      EXPECT_LE(m.participation, 1.0);
    }
  }
}

// A grid point on a backward critical speed of isotropic bearings has the limit of its neighbours.
TEST(Unbalance, LimitOnASpeedThatIsNotDriven) {
  const Model model = read_model(std::filesystem::path(GYROMODE_SOURCE_DIR) / "models" / "rotors" / "two_discs.toml");
  const double backward = model.critical_speeds().speeds[0].speed;
  Vector speeds(3);
  speeds << 0.9999 * backward, backward, 1.0001 * backward;
  const UnbalanceReport r = answered(model, {{"disk1", 1e-4, 0}}, speeds);
  ASSERT_EQ(r.response.points.size(), 3u);
  EXPECT_FALSE(r.response.points[1].resonance());
  // the nearest pole is 5.7e-3 away: (1e-4 / 5.7e-3)² of it between the mean and the middle
  const ComplexVector mean = 0.5 * (r.response.points[0].q + r.response.points[2].q);
  EXPECT_LE((r.response.points[1].q - mean).norm(), 4e-4 * mean.norm());
}

// A shaft that turns the other way moves as its mirror image.
TEST(Unbalance, ShaftThatTurnsTheOtherWay) {
  RotorParts parts;
  parts.speed = 100;
  parts.materials = {{"steel", 2e11, 8e10, 7800}};
  ShaftSection shaft;
  shaft.material = "steel";
  shaft.length = 1;
  shaft.outer_diameter[0] = shaft.outer_diameter[1] = 0.04;
  shaft.elements = 3;
  shaft.spool = "a";
  parts.shafts = {shaft};
  Disc disc;
  disc.position = 0.3;
  disc.offset = 0.05;
  disc.mass = 10;
  disc.polar_inertia = 0.2;
  disc.diametral_inertia = 0.1;
  disc.spool = "a";
  parts.discs = {disc};
  Bearing b;
  b.kxx = 1e6;
  b.kyy = 3e6;
  b.spool = "a";
  parts.bearings = {b, b};
  parts.bearings[1].position = 1;
  std::vector<std::vector<double>> major;
  for (const double ratio : {1.0, -1.0}) {
    parts.spools = {{"a", ratio, 0}};
    Model model(std::make_shared<RotorModel>(Rotor(parts)));
    model.frame = Frame::fixed;
    const UnbalanceReport r = answered(model, {{"disk1", 1e-3, 0}}, Vector::Constant(1, 150));
    EXPECT_EQ(r.response.order, 1);
    std::vector<double> all;
    for (const OrbitCoordinates& p : r.places) {
      all.push_back(orbit_of(r.response.points[0].q, p).major);
      all.push_back(ratio * orbit_of(r.response.points[0].q, p).minor);
    }
    major.push_back(all);
  }
  for (std::size_t k = 0; k < major[0].size(); ++k) EXPECT_NEAR(major[0][k], major[1][k], 1e-11 * std::abs(major[0][k]));
}

// The centre of an offset disc is at x + offset θy: so does the force.
TEST(Unbalance, OffsetDiscHasItsForceAtItsCentre) {
  const Model model = parse_model(R"(kind = "rotor"
speed = 10
[material.steel]
young = 2e11
shear = 8e10
density = 7800
[[shaft]]
length = 1
outer_diameter = 0.05
elements = 2
material = "steel"
[[disk]]
position = 0.5
offset = 0.1
mass = 5
polar_inertia = 0.1
diametral_inertia = 0.06
)",
                                  "offset.toml");
  const ComplexVector f = model.body->unbalance({{"disc1", 2, 0}}).per_speed2;
  const Labels& labels = model.labels();
  const auto at = [&](const char* label) { return f(std::find(labels.begin(), labels.end(), label) - labels.begin()); };
  EXPECT_EQ(at("x2"), Complex(2, 0));
  EXPECT_EQ(at("y2"), Complex(0, -2));
  EXPECT_NEAR(std::abs(at("theta_y2") - Complex(0.2, 0)), 0, 1e-16);
  EXPECT_NEAR(std::abs(at("theta_x2") - Complex(0, 0.2)), 0, 1e-16);
}

TEST(Unbalance, WhatIsRefused) {
  const Model model = jeffcott(1, 1, 1, false);
  EXPECT_THROW(answered(model, {{"y", 1, 0}}, Vector::Ones(1)), InvalidArgument);
  EXPECT_THROW(answered(model, {{"x", 0, 0}}, Vector::Ones(1)), InvalidArgument);
  EXPECT_THROW(answered(model, {{"x", 1, 0}}, Vector::Constant(1, -1)), InvalidArgument);
  Model unknown = model;
  unknown.frame = Frame::unknown;
  EXPECT_THROW(answered(unknown, {{"x", 1, 0}}, Vector::Ones(1)), NotApplicable);
}

}  // namespace
}  // namespace gyromode
