// Models in axes that turn, seen from fixed ones: orders of excitation, frequencies, names of modes.
#include "gyromode/models/model.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/read/read_model.h"
#include "gyromode/write/document.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace gyromode {
namespace {

const std::filesystem::path models = std::filesystem::path(GYROMODE_SOURCE_DIR) / "models";

// A mass on a shaft of stiffness kx, ky that turns with it, in axes that turn: the classical shaft of unequal
// stiffness.
Model unequal_shaft(double m, double kx, double ky, bool orbits = true) {
  return parse_model(
      fmt::format("kind = \"matrices\"\nlabels = [\"x\", \"y\"]\n{}frame = \"turning\"\nspin = 1\nmass = [{}, {}]\nstiffness = [{}, {}]\n"
                  "gyroscopic_per_spin = [[0, {}], [{}, 0]]\nstiffness_per_spin2 = [{}, {}]\n",
                  orbits ? "orbits = [[\"x\", \"y\"]]\n" : "", m, m, kx, ky, -2 * m, 2 * m, -m, -m),
      "shaft.toml");
}

CriticalSpeeds of_order(const Model& model, double order) {
  CriticalOptions o;
  o.order = order;
  return model.critical_speeds(o);
}

// Unbalance meets Ω² = kx/m and ky/m, between which the shaft diverges; weight, at rest in fixed axes, the secondary
// critical speed Ω² = kx ky / (2m(kx + ky)).
TEST(TurningAxes, CriticalSpeedsOfAShaftOfUnequalStiffness) {
  for (const double unit : {1.0, std::exp2(30), std::exp2(-30)}) {
    const double m = 2 * unit, kx = 18 * unit, ky = 50 * unit;
    const Model model = unequal_shaft(m, kx, ky);
    const CriticalSpeeds unbalance = of_order(model, 1);
    std::vector<double> forward, backward;
    for (const CriticalSpeed& c : unbalance.speeds) (c.whirl == Whirl::forward ? forward : backward).push_back(c.speed);
    ASSERT_EQ(forward.size(), 2u);
    EXPECT_NEAR(forward[0], 3, 1e-13);
    EXPECT_NEAR(forward[1], 5, 1e-13);
    // (kx − 5mΩ²)(ky − 5mΩ²) = (4mΩ²)²
    ASSERT_EQ(backward.size(), 2u);
    for (const double w : backward) EXPECT_NEAR((9 - 5 * w * w) * (25 - 5 * w * w) - 16 * std::pow(w, 4), 0, 1e-10);
    EXPECT_EQ(unbalance.coverage.status, CoverageStatus::complete);
    const CriticalSpeeds weight = of_order(model, 0);
    ASSERT_EQ(weight.speeds.size(), 1u);
    EXPECT_NEAR(weight.speeds[0].speed, std::sqrt(kx * ky / (2 * m * (kx + ky))), 1e-13);
  }
}

// Without orbits nothing can be left out, and the list is not called complete.
TEST(TurningAxes, WithoutOrbitsEveryRootIsListed) {
  const CriticalSpeeds found = of_order(unequal_shaft(1, 4, 4, false), 2);
  EXPECT_EQ(found.other_way, 0);
  EXPECT_TRUE(found.in_fixed_axes);
  EXPECT_EQ(found.coverage.status, CoverageStatus::not_counted);
}

// What is along the axis has one frequency in all axes: order m is mΩ there. Of coinciding roots as many are listed as
// have the part, whatever combinations a solver makes of them: fixed frequencies 10 and 30, order 3.
TEST(TurningAxes, AxialMotionAndCoincidingRoots) {
  const CriticalSpeeds axial = of_order(read_model(models / "three_springs.toml"), 1);
  EXPECT_TRUE(std::any_of(axial.speeds.begin(), axial.speeds.end(),
                          [](const CriticalSpeed& c) { return std::abs(c.speed - 500) < 1e-9 && !c.whirl; }));
  const double c = std::cos(0.7), s = std::sin(0.7);  // a rotation that mixes the two masses
  Matrix turn = Matrix::Zero(4, 4), k = turn, g = turn;
  turn << c, 0, s, 0, 0, c, 0, s, -s, 0, c, 0, 0, -s, 0, c;
  k.diagonal() << 100, 100, 900, 900;
  g(0, 1) = g(2, 3) = -2;
  g(1, 0) = g(3, 2) = 2;
  const auto text = [](const char* key, const Matrix& a) {
    std::string rows;
    for (Index i = 0; i < 4; ++i) rows += fmt::format("{}[{}, {}, {}, {}]", i > 0 ? ", " : "", a(i, 0), a(i, 1), a(i, 2), a(i, 3));
    return fmt::format("{} = [{}]\n", key, rows);
  };
  const Matrix mixed = turn.transpose() * k * turn, coriolis = turn.transpose() * g * turn;
  const Model model = parse_model(
      "kind = \"matrices\"\nframe = \"turning\"\nlabels = [\"x1\", \"y1\", \"x2\", \"y2\"]\nspin = 1\n"
      "orbits = [[\"x1\", \"y1\"], [\"x2\", \"y2\"]]\nmass = [1, 1, 1, 1]\nstiffness_per_spin2 = [-1, -1, -1, -1]\n" +
          text("stiffness", 0.5 * (mixed + mixed.transpose())) + text("gyroscopic_per_spin", 0.5 * (coriolis - coriolis.transpose())),
      "coinciding.toml");
  const CriticalSpeeds found = of_order(model, 3);
  ASSERT_EQ(found.speeds.size(), 4u);
  for (const std::size_t first : {std::size_t{0}, std::size_t{2}}) {
    EXPECT_NEAR(found.speeds[first].speed, first == 0 ? 10.0 / 3 : 10, 1e-9);
    EXPECT_NEAR(found.speeds[first + 1].speed, first == 0 ? 10.0 / 3 : 10, 1e-9);
    EXPECT_NE(found.speeds[first].whirl, found.speeds[first + 1].whirl);
  }
}

// The sense of the axes does not change what is forward.
TEST(TurningAxes, NegativeSpin) {
  for (const double spin : {2.0, -2.0}) {
    const Model model = unequal_shaft(1, 9, 16).with({{"spin", spin}});
    ModesOptions o;
    o.shapes = true;
    const ModesResult r = model.modes(o);
    const ModeDetails d = details_of(model, r);
    EXPECT_EQ(d.whirl[0], Whirl::forward) << spin;
    EXPECT_EQ(d.whirl[1], Whirl::backward) << spin;
  }
}

// A double speed is not cut in two.
TEST(TurningAxes, LowestOfADoubleSpeed) {
  const Model model = parse_model(
      "kind = \"matrices\"\nframe = \"fixed\"\nspin = 1\nmass = [1, 1]\nstiffness = [900, 900]\n"
      "gyroscopic_per_spin = [[0, 0], [0, 0]]\n",
      "double.toml");
  CriticalOptions o;
  o.lowest = 1;
  const CriticalSpeeds found = model.critical_speeds(o);
  EXPECT_EQ(found.speeds.size(), 2u);
  EXPECT_EQ(found.coverage.counted, 2);
}

// Axes change nothing: whatever the order, mΩ is a frequency of the chain in fixed axes, forward and backward.
TEST(TurningAxes, ChainHasTheCriticalSpeedsOfFixedAxes) {
  const Model model = read_model(models / "rotating_frame.toml");
  for (const double order : {0.5, 1.0, 2.0, 3.0}) {
    const CriticalSpeeds found = of_order(model, order);
    std::size_t forward = 0, backward = 0;
    for (const CriticalSpeed& c : found.speeds) {
      double nearest = 1;
      for (const double w2 : {2 - std::numbers::sqrt2, 2.0, 2 + std::numbers::sqrt2})
        nearest = std::min(nearest, std::abs(order * c.speed / std::sqrt(w2) - 1));
      EXPECT_LE(nearest, 1e-12) << order;
      ++(c.whirl == Whirl::forward ? forward : backward);
    }
    EXPECT_EQ(forward, 3u) << order;
    EXPECT_EQ(backward, 3u);
    EXPECT_EQ(found.coverage.status, CoverageStatus::complete) << order;
  }
}

// Roots at infinity are none: M − jG₁ − K₂ is singular.
TEST(TurningAxes, RootsAtInfinityAreLeftOut) {
  const CriticalSpeeds found = read_model(models / "rotating_frame.toml").body->critical_speeds({});
  EXPECT_EQ(found.speeds.size(), 3u);
  EXPECT_EQ(found.coverage.status, CoverageStatus::complete);
  EXPECT_GT(found.coverage.window.b, 1e5);
}

// Every mode of the chain is one of ±ω_k in fixed axes, whatever the spin.
TEST(TurningAxes, FrequenciesInFixedAxes) {
  const Model model = read_model(models / "rotating_frame.toml");
  for (const double spin : {0.3, 1.0, 1.9, 30.0, -0.7}) {
    const Model turning = model.with({{"spin", spin}});
    ModesOptions o;
    o.shapes = true;
    const ModesResult r = turning.modes(o);
    const ModeDetails d = details_of(turning, r);
    for (std::size_t k = 0; k < r.modes.size(); ++k) {
      ASSERT_EQ(d.fixed_axes[k].size(), 1u);
      const double w2 = std::pow(d.fixed_axes[k][0].omega, 2);
      const double nearest = std::min({std::abs(w2 - 2 + std::numbers::sqrt2), std::abs(w2 - 2), std::abs(w2 - 2 - std::numbers::sqrt2)});
      EXPECT_LE(nearest, 1e-13 * (1 + std::abs(spin)) * 10) << spin;
    }
  }
}

// A rigid body nutates at Ω(I₃ − I₁)/I₁ in its own axes and at ΩI₃/I₁ in fixed ones.
TEST(TurningAxes, NutationOfARigidBody) {
  for (const double i3 : {15.0, 5.0}) {
    const Model body =
        parse_model(fmt::format("kind = \"spacecraft\"\nspin = 2\n[body]\nmass = 100\ninertia = [10, 10, {}]\n", i3), "body.toml");
    ModesOptions o;
    o.shapes = true;
    const ModesResult r = body.modes(o);
    const ModeDetails d = details_of(body, r);
    bool named = false;
    for (std::size_t k = 0; k < r.modes.size(); ++k) {
      if (d.names[k] != "nutation") continue;
      named = true;
      EXPECT_NEAR(r.modes[k].omega, 2 * std::abs(i3 - 10) / 10, 1e-12);
      ASSERT_EQ(d.fixed_axes[k].size(), 1u);
      EXPECT_NEAR(d.fixed_axes[k][0].omega, 2 * i3 / 10, 1e-12);
    }
    EXPECT_TRUE(named) << i3;
  }
}

// One mode of each satellite is the nutation.
TEST(TurningAxes, SatellitesHaveOneNutation) {
  for (const char* name : {"geos", "ispm", "ulysses", "mms", "themis", "cluster"}) {
    const Model model = read_model(models / (std::string(name) + ".toml"));
    ModesOptions o;
    o.shapes = true;
    o.lowest = 12;
    const ModeDetails d = details_of(model, model.modes(o));
    EXPECT_EQ(std::count(d.names.begin(), d.names.end(), "nutation"), 1) << name;
  }
}

// Documents hold them.
TEST(TurningAxes, InDocuments) {
  const Model model = unequal_shaft(2, 18, 50);
  CampbellOptions o;
  o.spins = {1, 2};
  const auto campbell = nlohmann::json::parse(document(model, model.campbell(o), {}, Format::json));
  const double omega = campbell["branches"][0]["omega"][0];
  std::vector<double> parts = campbell["branches"][0]["fixed_axes"][0];
  ASSERT_EQ(parts.size(), 2u);
  std::sort(parts.begin(), parts.end());
  EXPECT_NEAR(parts[0], 1 - omega, 1e-13);
  EXPECT_NEAR(parts[1], 1 + omega, 1e-13);
  const auto critical = nlohmann::json::parse(document(model, of_order(model, 1), {}, Format::json));
  EXPECT_EQ(critical["critical_speeds"].size(), 4u);
  EXPECT_EQ(critical["critical_speeds"][0]["whirl"].is_string(), true);
}

}  // namespace
}  // namespace gyromode
