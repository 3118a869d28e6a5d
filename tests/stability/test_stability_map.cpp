#include "gyromode/base/error.h"
#include "gyromode/models/matrices.h"
#include "gyromode/models/stability_over.h"
#include "gyromode/read/read_model.h"
#include "gyromode/models/spacecraft_model.h"
#include "gyromode/modes/modes.h"
#include "gyromode/modes/spacecraft.h"
#include "gyromode/stability/stability_margin.h"
#include "gyromode/stability/stability_map.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace gyromode;

namespace {

StabilityPoint verdict(const System& s) { return stability_point(find_modes(s)); }

Matrix turning(double g) { return Matrix{{0, -g}, {g, 0}}; }
Matrix diagonal(double a, double b) { return Matrix{{a, 0}, {0, b}}; }

std::vector<double> grid(double a, double b, int n) {
  std::vector<double> x;
  for (int k = 0; k < n; ++k) x.push_back(a + (b - a) * k / (n - 1));
  return x;
}

std::vector<double> values(const StabilityMap& m) {
  std::vector<double> all;
  for (const CriticalValue& c : m.critical) all.push_back(c.value);
  return all;
}

// Every cell by its closed form; a cell within rounding of a boundary may be marginal.
void expect_no_wrong_cell(const StabilityMap& m, const std::function<Stability(double, double)>& exact,
                          const std::function<double(double, double)>& distance) {
  std::size_t wrong = 0;
  for (const auto& [at, p] : m.cells) {
    if (std::abs(distance(at[0], at[1])) < 1e-12) continue;
    wrong += p.stability == exact(at[0], at[1]) ? 0 : 1;
    EXPECT_EQ(to_string(p.stability), to_string(exact(at[0], at[1]))) << at[0] << ", " << at[1];
  }
  EXPECT_EQ(wrong, 0u);
}

}  // namespace

// B2, published: unequal stiffness in turning axes, unstable between ω₁ = 1 and ω₂ = 1.5.
TEST(StabilityMap, UnequalStiffness) {
  const auto at = [](double spin, double w2) {
    return verdict(System(Matrix::Identity(2, 2), turning(2 * spin), diagonal(1 - spin * spin, w2 * w2 - spin * spin)));
  };
  const StabilityMap line = map_stability([&](const std::vector<double>& v) { return at(v[0], 1.5); }, {grid(0, 2, 14)});
  ASSERT_EQ(line.critical.size(), 2u);
  EXPECT_NEAR(line.critical[0].value, 1, 1e-12);
  EXPECT_NEAR(line.critical[1].value, 1.5, 1e-12);
  EXPECT_EQ(to_string(line.critical[1].to.stability), "gyroscopically_stabilised");
  const StabilityMap chart =
      map_stability([&](const std::vector<double>& v) { return at(v[0], v[1]); }, {grid(0.013, 2.5, 100), grid(1.05, 2.2, 100)});
  EXPECT_EQ(chart.cells.size(), 10000u);
  expect_no_wrong_cell(
      chart,
      [](double spin, double w2) {
        return spin < 1 ? Stability::stable : spin < w2 ? Stability::unstable : Stability::gyroscopically_stabilised;
      },
      [](double spin, double w2) { return (spin - 1) * (spin - w2); });
  for (const CriticalValue& c : chart.critical) {
    EXPECT_NEAR(c.value, c.from.stability == Stability::unstable ? c.others[0] : 1, 1e-10);
  }
}

// B3: K = −diag(k₁, k₂), stable from g = √k₁ + √k₂ on, where roots of opposite energy meet.
TEST(StabilityMap, GyroscopicThreshold) {
  const auto at = [](double g, double k2) { return verdict(System(Matrix::Identity(2, 2), turning(g), diagonal(-1, -k2))); };
  for (const int points : {2, 12, 11}) {  // of these the last has the threshold itself on its grid
    const StabilityMap line = map_stability([&](const std::vector<double>& v) { return at(v[0], 4); }, {grid(2, 4, points)});
    ASSERT_EQ(line.critical.size(), 1u) << points;
    EXPECT_NEAR(line.critical[0].value, 3, 1e-10);
    EXPECT_EQ(to_string(line.critical[0].from.stability), "unstable");
    EXPECT_EQ(to_string(line.critical[0].to.stability), "gyroscopically_stabilised");
  }
  const StabilityMap chart =
      map_stability([&](const std::vector<double>& v) { return at(v[0], v[1]); }, {grid(0.02, 6, 100), grid(0.1, 9.7, 100)});
  expect_no_wrong_cell(
      chart, [](double g, double k2) { return g < 1 + std::sqrt(k2) ? Stability::unstable : Stability::gyroscopically_stabilised; },
      [](double g, double k2) { return g - 1 - std::sqrt(k2); });
  for (const CriticalValue& c : chart.critical) {
    // √k₂ + 1 is the threshold of stability, |√k₂ − 1| that from divergence to flutter.
    const double root = std::sqrt(c.others[0]);
    EXPECT_LE(std::min(std::abs(c.value - 1 - root), std::abs(c.value - std::abs(root - 1))), 1e-10) << c.others[0];
  }
}

// A1: the mass on three springs by its model file; thresholds √(Kx/m), √(Ky/m).
TEST(StabilityMap, MassOnThreeSpringsFromItsFile) {
  const Model model = read_model(GYROMODE_SOURCE_DIR "/models/three_springs.toml");
  const StabilityMap chart = stability_over(*model.body, {{"spin", grid(10, 1500, 100)}, {"stiffness[0][0]", grid(2e4, 1.5e5, 100)}});
  expect_no_wrong_cell(
      chart,
      [](double spin, double kx) {
        return spin * spin < kx / 0.2 ? Stability::stable : spin < 1000 ? Stability::unstable : Stability::gyroscopically_stabilised;
      },
      [](double spin, double kx) { return (spin * spin - kx / 0.2) * (spin - 1000); });
  ASSERT_EQ(chart.critical.size(), 200u);
  for (std::size_t k = 0; k < chart.critical.size(); ++k) {
    const double exact = k % 2 == 0 ? std::sqrt(chart.critical[k].others[0] / 0.2) : 1000;
    EXPECT_NEAR(chart.critical[k].value, exact, 1e-10 * exact);
  }
}

// A rigid body over I₃: stable as the largest, unstable as the middle, stabilised as the smallest inertia.
TEST(StabilityMap, RigidBodyOverTheSpinInertia) {
  const auto at = [](double i3, double i1) {
    constexpr double i2 = 110, spin = 1.0471975511966;
    return verdict(System(diagonal(i1, i2), turning((i1 + i2 - i3) * spin), spin * spin * diagonal(i3 - i2, i3 - i1)));
  };
  const StabilityMap chart =
      map_stability([&](const std::vector<double>& v) { return at(v[0], v[1]); }, {grid(41, 199, 100), grid(55, 105, 100)});
  expect_no_wrong_cell(
      chart,
      [](double i3, double i1) {
        return i3 > 110 ? Stability::stable : i3 > i1 ? Stability::unstable : Stability::gyroscopically_stabilised;
      },
      [](double i3, double i1) { return (i3 - 110) * (i3 - i1); });
  ASSERT_EQ(chart.critical.size(), 200u);
  for (std::size_t k = 0; k < chart.critical.size(); ++k)
    EXPECT_NEAR(chart.critical[k].value, k % 2 == 0 ? chart.critical[k].others[0] : 110, 1e-10 * 110);
}

TEST(StabilityMap, UnlawfulCellsAreLeftBlank) {
  const auto at = [](const std::vector<double>& v) -> StabilityPoint {
    if (v[0] > 2) return {false, Stability::unknown, {}, 0, "no such model"};
    return {true, v[0] < 1 ? Stability::stable : Stability::unstable, {}, 0, ""};
  };
  const StabilityMap m = map_stability(at, {grid(0, 4, 9)});
  EXPECT_EQ(values(m).size(), 1u);
  EXPECT_NEAR(m.critical[0].value, 1, 1e-13);
}

TEST(Parameters, OfASpacecraft) {
  const std::string text =
      "kind = \"spacecraft\"\nspin = \"10 rpm\"\n[body]\nmass = 260\ninertia = [90.0, 110.0, 150.0]\n"
      "[[cable]]\nazimuth = 0\nradius = 1\nheight = 0\nlength = \"20 m\"\nline_density = 0.002\n"
      "[[cable]]\nazimuth = \"180 deg\"\nradius = 1\nheight = 0\nlength = 20\nline_density = 0.002\n";
  const Model m = parse_model(text, "craft.toml");
  for (const char* key : {"spin", "body.inertia[2]", "cable[*].length", "cable[0].length,cable[1].length", "body.mass"})
    EXPECT_NO_THROW(require_parameter(*m.body, key)) << key;
  const Spacecraft craft =
      dynamic_cast<const SpacecraftModel&>(*m.body->with({{"cable[*].length", 31.5}, {"body.inertia[2]", 140}})).spacecraft();
  EXPECT_EQ(craft.cables()[0].length, 31.5);
  EXPECT_EQ(craft.cables()[1].length, 31.5);
  EXPECT_EQ(craft.body().inertia(2, 2), 140);
  const auto message = [&](const std::string& key) {
    try {
      require_parameter(*m.body, key);
    } catch (const InvalidArgument& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(message("body.intertia[2]"), "'body.intertia[2]' is no parameter of the model: did you mean 'body.inertia[2]'?");
  EXPECT_EQ(message("cable[*].lenght"), "'cable[*].lenght' is no parameter of the model: did you mean 'cable[*].length'?");
  EXPECT_NE(message("body.inertia[3]"), "no error");
  EXPECT_NE(message("kind"), "no error");
  EXPECT_NE(message("cable[-1].length"), "no error");
  EXPECT_NE(message(""), "no error");
  EXPECT_NE(message("body..mass"), "no error");
  EXPECT_THROW(m.body->with({{"body.inertia[2]", 500}}), LawBroken);  // the triangle inequality
  EXPECT_THROW(m.body->with({{"body.inertia[5]", 100}}), InvalidArgument);
}

// Every parameter that a shipped model lists: set to what it is, nothing changes; set to another value, that value is
// read back.
TEST(Parameters, OfEveryShippedModelAreReadBack) {
  Index models = 0, changed = 0;
  for (const auto& entry : std::filesystem::directory_iterator(GYROMODE_SOURCE_DIR "/models")) {
    if (entry.path().extension() != ".toml") continue;
    ++models;
    const Model m = read_model(entry.path());
    for (const Parameter& p : m.body->parameters()) {
      ASSERT_TRUE(m.body->parameter(p.key)) << p.key;
      EXPECT_EQ(m.body->with({{p.key, p.value}})->parameter(p.key)->value, p.value) << entry.path() << p.key;
      try {
        const double other = p.value == 0 ? 1e-3 : 1.0009765625 * p.value;
        EXPECT_EQ(m.body->with({{p.key, other}})->parameter(p.key)->value, other) << entry.path() << p.key;
        ++changed;
      } catch (const LawBroken&) {  // one of two equal booms changed: no equilibrium
      }
    }
  }
  EXPECT_GT(models, 10);
  EXPECT_GT(changed, 10 * models);
}

// M, G, K of a family in spin: the spin scales G₁ and K₂; one entry is its mirror image too.
TEST(Parameters, OfMatrices) {
  const SpinFamily family{Matrix::Identity(2, 2), turning(0.5), turning(2), diagonal(4, 9), diagonal(-1, -1), {}};
  const Model at_three(family, 3);
  const ModelKind& model = *at_three.body;
  const auto system = [](const std::shared_ptr<const ModelKind>& m) { return *m->second_order(); };
  EXPECT_EQ(system(model.with({{"spin", 2}})).gyroscopic(), turning(4.5));
  EXPECT_EQ(system(model.with({{"spin", 2}})).stiffness(), diagonal(0, 5));
  EXPECT_EQ(system(model.with({{"stiffness[0][1]", 0.25}, {"spin", 0}})).stiffness(), (Matrix{{4, 0.25}, {0.25, 9}}));
  EXPECT_EQ(system(model.with({{"gyroscopic[0][1]", 7}, {"spin", 0}})).gyroscopic(), (Matrix{{0, 7}, {-7, 0}}));
  EXPECT_EQ(system(model.with({{"stiffness_per_spin2[*][*]", 0.5}})).stiffness(), (Matrix{{8.5, 4.5}, {4.5, 13.5}}));
  EXPECT_FALSE(model.parameter("gyroscopic[0][0]"));  // 0 by the law
  EXPECT_FALSE(model.parameter("stiffness[2][0]"));
  EXPECT_FALSE(model.parameter("stiffness[0]"));
  EXPECT_FALSE(MatricesModel(family.at(3)).parameter("spin"));  // nothing depends on it
  // Without its weak couplings a model has the parameters of the whole one.
  const auto without = model.without_couplings(0.1).first;
  EXPECT_EQ(without->parameter("spin")->value, 3);
  EXPECT_EQ(system(without->with({{"stiffness[0][1]", 0.25}})).stiffness(), diagonal(-5, 0));
}

// Every mistake that a caller can make is an exception, and no entry is given two values.
TEST(Parameters, ValuesThatContradictEachOther) {
  const Model at_three(SpinFamily{Matrix::Identity(2, 2), turning(0.5), turning(2), diagonal(4, 9), {}, {}}, 3);
  const ModelKind& model = *at_three.body;
  EXPECT_EQ(model.with({{"gyroscopic[*][*]", 7}, {"spin", 0}})->second_order()->gyroscopic()(0, 1), 7);
  EXPECT_THROW(model.with({{"gyroscopic[0][1]", 7}, {"gyroscopic[1][0]", 7}}), InvalidArgument);
  EXPECT_NO_THROW(model.with({{"stiffness[0][1]", 1}, {"stiffness[1][0]", 1}}));
  EXPECT_THROW(model.with({{"spin", 1}, {"spin", 2}}), InvalidArgument);
  const Model craft = read_model(GYROMODE_SOURCE_DIR "/models/geos.toml");
  EXPECT_THROW(craft.with({{"cable[*].length", 20}, {"cable[0].length", 21}}), InvalidArgument);
  EXPECT_THROW(require_parameter(*craft.body, "body.mass,cable[0].length"), InvalidArgument);  // kg and m
  EXPECT_THROW(Model(SpinFamily{Matrix::Identity(2, 2), turning(1), Matrix::Zero(3, 3), diagonal(4, 9), {}, {}}, 1), LawBroken);
}

TEST(Parameters, AfterCouplingsWereLeftOut) {
  const Model whole(System(Matrix::Identity(2, 2), turning(1), Matrix{{4, 0.1}, {0.1, 9}}));
  const Model without = whole.without_couplings(0.05).with({{"stiffness[0][1]", 0.2}});
  EXPECT_EQ(without.body->second_order()->stiffness()(0, 1), 0);
  EXPECT_NEAR(without.ignored->largest, 0.2 / 9, 1e-15);
  const FirstOrderModel first(FirstOrderSystem(Matrix{{1, 0.01}, {0.01, 1}}, turning(2)));
  EXPECT_EQ(first.without_couplings(0.1).first->parameter("inertia[0][1]")->value, 0.01);
}

TEST(StabilityMap, RefusesAxesThatAreNone) {
  const Model model = read_model(GYROMODE_SOURCE_DIR "/models/three_springs.toml");
  EXPECT_THROW(model.stability_over({}), InvalidArgument);
  EXPECT_THROW(model.stability_over({{"spin", {}}}), InvalidArgument);
  EXPECT_THROW(model.stability_over({{"spin", {2, 1}}}), InvalidArgument);
  EXPECT_THROW(model.stability_over({{"spin", {1, 2}}, {"mass[0][0]", {1, 2}}, {"mass[1][1]", {1, 2}}}), InvalidArgument);
}

TEST(Parameters, OfAFirstOrderModel) {
  const FirstOrderModel model(FirstOrderSystem(Matrix::Identity(2, 2), turning(2)));
  EXPECT_EQ(model.parameter("gyroscopic[1][0]")->value, -model.parameter("gyroscopic[0][1]")->value);
  EXPECT_NEAR(model.with({{"gyroscopic[0][1]", 5}})->verdict(false).modes[0].omega, 5, 1e-14);
  EXPECT_THROW(model.with({{"inertia[0][0]", -1}}), LawBroken);
}

TEST(StabilityMap, StoppedKeepsWhatIsKnown) {
  Index seen = 0;
  Progress progress;
  progress.stop = [&] { return seen >= 7; };
  const auto at = [&](const std::vector<double>& v) -> StabilityPoint {
    return ++seen, StabilityPoint{true, v[0] < 1 ? Stability::stable : Stability::unstable, {}, 0, ""};
  };
  const StabilityMap m = map_stability(at, {grid(0, 4, 5), grid(0, 1, 3)}, progress);
  EXPECT_TRUE(m.interrupted);
  ASSERT_EQ(m.cells.size(), 15u);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_TRUE(m.cells[k].point.decided());
  EXPECT_FALSE(m.cells.back().point.decided());
  EXPECT_EQ(m.cells.back().point.reason, "interrupted");
  EXPECT_EQ(m.cells.back().values, (std::vector<double>{4, 1}));
  EXPECT_TRUE(m.critical.empty());  // of no finished row
}

TEST(StabilityMargin, PairAndStiffness) {
  const System s(Matrix::Identity(2, 2), turning(3.1), diagonal(-1, -4));
  const auto pair = nearest_opposite_pair(find_modes(s).modes);
  ASSERT_TRUE(pair);
  EXPECT_NEAR((*pair)[0], 1.0766275913, 1e-9);
  EXPECT_NEAR((*pair)[1], 1.8576525589, 1e-9);
  EXPECT_NEAR(*stiffness_margin(s, 0), -1, 1e-15);
  EXPECT_FALSE(nearest_opposite_pair(find_modes(System(Matrix::Identity(2, 2), turning(1), diagonal(1, 4))).modes));
}
