// Campbell diagrams of rotors: every spin against its own solution, intersections against bisection on the branches,
// and the events of what has a closed form.
#include "gyromode/base/error.h"
#include "gyromode/models/model.h"
#include "gyromode/models/rotor_model.h"
#include "gyromode/read/read_model.h"
#include "support/random_rotor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <regex>

namespace gyromode {
namespace {

const std::filesystem::path source_dir = GYROMODE_SOURCE_DIR;

std::vector<double> evenly(double a, double b, int n) {
  std::vector<double> all;
  for (int k = 0; k < n; ++k) all.push_back(a + (b - a) * k / (n - 1));
  return all;
}

// ω of all branches at a spin, ascending.
std::vector<SampledMode> at_spin(const Campbell& c, std::size_t s) {
  std::vector<SampledMode> all;
  for (const CampbellBranch& b : c.branches) {
    if (b.modes[s]) all.push_back(*b.modes[s]);
  }
  std::sort(all.begin(), all.end(), [](const SampledMode& x, const SampledMode& y) { return x.omega < y.omega; });
  return all;
}

// Many stations, so that spins share their subspaces.
TEST(CampbellRotors, EverySpinIsItsOwnSolution) {
  for (const char* name : {"two_discs.toml", "two_discs_orthotropic.toml", "twin_spool.toml"}) {
    std::ifstream file(source_dir / "models" / "rotors" / name);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const Model model = parse_model(std::regex_replace(text, std::regex("elements = [0-9]+"), "elements = 20"), name);
    ASSERT_GT(model.size(), 60);
    CampbellOptions o;
    o.spins = evenly(0, 1500, 13);
    o.lowest = 9;
    const Campbell c = model.campbell(o);
    EXPECT_TRUE(c.is_complete()) << name;
    for (std::size_t s = 0; s < c.spins.size(); ++s) {
      ModesOptions each;
      each.lowest = 9;
      const ModesResult own = model.with({{"speed", c.spins[s]}}).modes(each);
      const std::vector<SampledMode> found = at_spin(c, s);
      ASSERT_EQ(found.size(), own.modes.size()) << name << " " << c.spins[s];
      for (std::size_t k = 0; k < found.size(); ++k)
        EXPECT_NEAR(found[k].omega, own.modes[k].omega, 2 * (found[k].error + own.modes[k].error_bound)) << name << " " << c.spins[s];
    }
  }
}

Index below(const Model& model, double spin, double omega) {
  ModesOptions o;
  o.window.b = omega;
  const ModesResult r = model.with({{"speed", spin}}).modes(o);
  Index all = 0;
  for (const Mode& m : r.modes) all += m.kind == ModeKind::rigid_body || m.omega >= omega ? 0 : m.multiplicity;
  return all;
}

// Of seeded rotors the number of modes below mΩ changes at every intersection, by bisection to 10⁻¹⁰ or to what the
// frequencies are known to, and between two spins by no more than the intersections there.
TEST(CampbellRotors, IntersectionsAreThoseOfTheBranches) {
  const char* count = std::getenv("GYROMODE_ROTORS");
  const int draws = count ? std::atoi(count) : 40;
  support::Source source{std::mt19937_64(41)};
  int all = 0;
  for (int draw = 0; draw < draws; ++draw) {
    Rotor rotor(support::random_rotor(source));
    const Model model(std::make_shared<RotorModel>(rotor));
    const double order = draw % 3 == 0 ? 1 : draw % 3 == 1 ? 0.5 : 2;
    CampbellOptions o;
    o.spins = evenly(draw % 2 == 0 ? 0 : 37, 2000, 9);
    o.below = order * 2100;
    o.orders = {order};
    Campbell c;
    try {
      c = model.campbell(o);
    } catch (const InvalidArgument&) {
      continue;  // no mode in the window
    }
    if (!c.is_complete() || c.excitation[0].coverage.status != CoverageStatus::complete) continue;
    std::vector<double> spins;
    for (const Intersection& x : c.excitation[0].all) {
      ASSERT_GE(x.branch, 0);
      spins.push_back(x.spin);
      const double width = std::max(1e-10 * x.spin, 8 * x.error);
      const Index lo = below(model, x.spin - width, order * (x.spin - width)), hi = below(model, x.spin + width, order * (x.spin + width));
      EXPECT_NE(lo, hi) << draw << ": " << x.spin;
      // The branch it is said to be on goes through the line between the spins beside.
      const auto& modes = c.branches[static_cast<std::size_t>(x.branch)].modes;
      for (std::size_t s = 0; s + 1 < c.spins.size(); ++s) {
        if (!(c.spins[s] < x.spin && x.spin < c.spins[s + 1]) || !modes[s] || !modes[s + 1]) continue;
        const double reach = 1.5 * (c.spins[s + 1] - c.spins[s]) * (order + std::abs(modes[s]->slope.value_or(1e3)) + 1);
        EXPECT_NEAR(modes[s]->omega, order * x.spin, reach) << draw;
      }
      ++all;
    }
    for (std::size_t s = 0; s + 1 < c.spins.size(); ++s) {
      if (c.spins[s] == 0) continue;
      const Index net = below(model, c.spins[s + 1], order * c.spins[s + 1]) - below(model, c.spins[s], order * c.spins[s]);
      const auto inside = std::count_if(spins.begin(), spins.end(), [&](double x) { return x >= c.spins[s] && x < c.spins[s + 1]; });
      EXPECT_LE(std::abs(net), inside) << draw << " " << s;
      EXPECT_EQ((std::abs(net) - inside) % 2, 0) << draw << " " << s;
    }
  }
  std::printf("%d intersections\n", all);
}

// Isotropic: forward and backward whirl cross; the same with unequal bearings veers.
TEST(CampbellRotors, UnequalBearingsTurnACrossingIntoAVeering) {
  CampbellOptions o;
  o.spins = evenly(0, 1600, 17);
  o.lowest = 10;
  const Campbell round = read_model(source_dir / "models/rotors/two_discs.toml").campbell(o);
  const Campbell unequal = read_model(source_dir / "models/rotors/two_discs_orthotropic.toml").campbell(o);
  const auto kinds = [](const Campbell& c, EncounterKind kind) {
    return std::count_if(c.encounters.begin(), c.encounters.end(), [&](const Encounter& e) { return e.kind == kind; });
  };
  EXPECT_GT(kinds(round, EncounterKind::crossing), 0);
  EXPECT_EQ(kinds(round, EncounterKind::veering), 0);
  EXPECT_EQ(kinds(unequal, EncounterKind::crossing), 0);
  EXPECT_GT(kinds(unequal, EncounterKind::veering), 0);
  for (const CampbellBranch& b : round.branches) {
    for (std::size_t s = 0; s < b.modes.size(); ++s) {
      if (!b.modes[s]) continue;
      EXPECT_EQ(*b.modes[s]->whirl == Whirl::degenerate, round.spins[s] == 0);
      EXPECT_NE(*b.modes[s]->whirl, Whirl::mixed);
    }
  }
}

// The translations of a wheel on a round mount are double at every spin: no way round is theirs.
TEST(CampbellRotors, DoubleModesAreDegenerate) {
  CampbellOptions o;
  o.spins = evenly(0, 600, 7);
  o.lowest = 4;
  const Campbell c = read_model(source_dir / "models/rotors/momentum_wheel.toml").campbell(o);
  ASSERT_EQ(c.branches.size(), 4U);
  std::size_t degenerate = 0;
  for (const CampbellBranch& b : c.branches) degenerate += *b.modes.back()->whirl == Whirl::degenerate ? 1 : 0;
  EXPECT_EQ(degenerate, 2U);
}

// Two unlike discs on a shaft, turning axes: branches of opposite energy sign meet and part; the interval is that of
// the stability map.
TEST(CampbellRotors, CollisionsHaveTheIntervalOfTheStabilityMap) {
  const Model model = read_model(source_dir / "models" / "turned_rotor.toml");
  CampbellOptions o;
  o.spins = evenly(0, 1200, 7);
  const Campbell c = model.campbell(o);
  const auto collision =
      std::find_if(c.encounters.begin(), c.encounters.end(), [](const Encounter& e) { return e.kind == EncounterKind::collision; });
  ASSERT_NE(collision, c.encounters.end());
  ASSERT_TRUE(collision->flutter);
  const auto& [from, to] = *collision->flutter;
  const auto verdict = [&](double spin) { return model.with({{"spin", spin}}).stability().result.stability; };
  EXPECT_EQ(verdict(0.5 * (from + to)), Stability::unstable);
  EXPECT_NE(verdict(from * (1 - 1e-6)), Stability::unstable);
  EXPECT_NE(verdict(to * (1 + 1e-6)), Stability::unstable);
  // The branches are there before and after.
  for (const Index b : collision->branches) {
    const auto& modes = c.branches[static_cast<std::size_t>(b)].modes;
    EXPECT_TRUE(std::any_of(modes.begin(), modes.end(), [](const auto& m) { return m.has_value(); }));
  }
}

TEST(CampbellRotors, BadRequestsAreRefused) {
  const Model model = read_model(source_dir / "models" / "rotors" / "two_discs.toml");
  CampbellOptions o;
  EXPECT_THROW(model.campbell(o), InvalidArgument);
  o.spins = {1, 0};
  EXPECT_THROW(model.campbell(o), InvalidArgument);
  o.spins = {0, 1, 1};
  EXPECT_THROW(model.campbell(o), InvalidArgument);
  o.spins = {0, 1};
  o.lowest = 0;
  EXPECT_THROW(model.campbell(o), InvalidArgument);
  o.lowest = 3;
  o.orders = {-1};
  EXPECT_THROW(model.campbell(o), InvalidArgument);
  o.orders = {1};
  o.below = 0;
  EXPECT_THROW(model.campbell(o), InvalidArgument);
  EXPECT_THROW(read_model(source_dir / "models" / "wiresaw.toml").campbell({{0, 1}, 100, {}, {1}, {}}), NotApplicable);
}

}  // namespace
}  // namespace gyromode
