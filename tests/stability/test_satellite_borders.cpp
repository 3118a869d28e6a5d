// Critical values of satellites over an inertia, against closed forms, on any grid.
#include "gyromode/modes/spacecraft.h"
#include "gyromode/stability/border.h"
#include "gyromode/stability/stability_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gyromode {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<double> grid(double a, double b, int n) {
  std::vector<double> x;
  for (int k = 0; k < n; ++k) x.push_back(k + 1 == n ? b : a + (b - a) * k / (n - 1));
  return x;
}

StabilityPoint verdict(const Spacecraft& s) {
  ModesOptions options;
  options.lowest = 1;
  return stability_point(find_modes(s, options));
}

StabilityMap over_j3(double mass, double j1, double j2, double spin, const std::vector<Cable>& wires, const std::vector<Beam>& beams,
                     const std::vector<double>& values) {
  return map_stability(
      [&](const std::vector<double>& v) {
        return verdict(Spacecraft(spin, {mass, Eigen::Vector3d(j1, j2, v[0]).asDiagonal()}, wires, beams));
      },
      {values});
}

std::vector<Cable> ring(std::initializer_list<double> degrees, double radius, double height, double length, double density, double tip) {
  std::vector<Cable> all;
  for (const double d : degrees) all.push_back({d * pi / 180, radius, height, length, density, tip});
  return all;
}

void expect_values(const StabilityMap& m, const std::vector<double>& expected, double tolerance) {
  ASSERT_EQ(m.critical.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(m.critical[k].value, expected[k], tolerance);
  for (const StabilityMap::Cell& c : m.cells) EXPECT_TRUE(c.point.decided()) << c.values[0];
  EXPECT_LE(m.evaluations, static_cast<Index>(expected.size()) * BorderSearch::most_evaluations);
}

TEST(SatelliteBorders, ARigidBody) {
  for (const int n : {2, 3, 7, 40}) expect_values(over_j3(100, 100, 110, 1, {}, {}, grid(80, 131, n)), {100, 110}, 1e-10);
  for (const double spin : {1e-4, 30.0}) expect_values(over_j3(100, 100, 110, spin, {}, {}, grid(80, 131, 5)), {100, 110}, 1e-10);
}

TEST(SatelliteBorders, ABodyWithWires) {
  const auto four = ring({0, 90, 180, 270}, 0.5, 0, 3, 0.01, 0.1);
  EXPECT_NEAR(2 * 0.5 * four[0].first_moment(), 0.41, 1e-15);  // 2aS
  for (const int n : {2, 7, 8}) expect_values(over_j3(100, 100, 110, 1, four, {}, grid(80, 130, n)), {99.59, 109.59}, 1e-9);
  expect_values(over_j3(100, 100, 110, 1, ring({30, 120, 210, 300}, 0.5, 0, 3, 0.01, 0.1), {}, grid(80, 130, 6)), {99.59, 109.59}, 1e-9);
  expect_values(over_j3(100, 100, 110, 1, ring({0, 180}, 0.5, 0, 3, 0.01, 0.1), {}, grid(80, 130, 5)), {99.59, 110}, 1e-9);
}

// Four long wires between the axes, two soft booms: two critical values as far apart as J₁ and J₂, and flutter from
// 108.98 to 110.93, whose ends are known to the band that has no verdict: as squares of gaps and of growth rates on
// both sides, linear in J₃, extrapolate to zero.
TEST(SatelliteBorders, ASatelliteWithBooms) {
  const auto wires = ring({45, 135, 225, 315}, 0.9, 0.05, 40, 1.1e-3, 0.12);
  const std::vector<Beam> beams{{0.6, true, 6, 0.09, {900, 900}, 0.25}, {-0.6, false, 6, 0.09, {900, 900}, 0.25}};
  for (const auto& values : {grid(90, 190, 11), grid(100, 170, 8)}) {
    const StabilityMap m = over_j3(310, 98, 112, pi / 2, wires, beams, values);
    ASSERT_EQ(m.critical.size(), 4u);
    EXPECT_NEAR(m.critical[0].value, 108.9804092014, 2e-9);
    EXPECT_NEAR(m.critical[1].value, 110.934648058, 5e-9);
    EXPECT_NEAR(m.critical[2].value, 129.60173720315, 1e-9);
    EXPECT_NEAR(m.critical[3].value, m.critical[2].value + 14, 1e-9);
    for (const StabilityMap::Cell& c : m.cells) EXPECT_TRUE(c.point.decided()) << c.values[0];
  }
}

// Three masses on springs that the spin makes soft, one after the other: √(k/m) = √20 is the critical spin of those
// that move against each other. Ten and more digits on any grid.
TEST(SatelliteBorders, SoftSprings) {
  constexpr double rigid = std::numeric_limits<double>::infinity();
  const auto at = [&](double spin) {
    return verdict(Spacecraft(spin, {100, Eigen::Vector3d(100, 110, 150).asDiagonal()}, {}, {},
                              {{{0, 0, 0.5}, 2, {8, 20, 50}}, {{0.6, 0, 0}, 1, {8, 20, rigid}}, {{-0.6, 0, 0}, 1, {8, 20, rigid}}}));
  };
  for (const int n : {8, 21, 24}) {
    const StabilityMap m = map_stability([&](const std::vector<double>& v) { return at(v[0]); }, {grid(0.3, 6, n)});
    const std::vector<double> expected{2.009343907646,  2.855843860553, 2.857114783162, 3.172894202731,
                                       std::sqrt(20.0), 4.517492930624, 4.586602037863, 4.905706975389};
    ASSERT_EQ(m.critical.size(), expected.size()) << n;
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(m.critical[k].value, expected[k], 1e-9) << n;
  }
}

// A satellite that is unstable throughout: at 111.966 two divergences become flutter, in rounding that once was taken
// for hundreds of borders.
TEST(SatelliteBorders, DivergencesThatMeet) {
  const auto at = [](double j1) {
    return verdict(Spacecraft(3, {239.96659877657888, Eigen::Vector3d(j1, 125.1593967576169, 95.91290601536501).asDiagonal()},
                              {{2.8507690511330983, 1, 0, 20, 0.03, 0.05}, {5.992361704722891, 1, 0, 20, 0.03, 0.05}},
                              {{0.28503602079697293, false, 1.4393721064437308, 0.2, {7.672069967616948, 28.77026237856355}, 1.0}}));
  };
  std::vector<CriticalValue> first;
  for (const int n : {2, 3, 30}) {
    const StabilityMap m =
        map_stability([&](const std::vector<double>& v) { return at(v[0]); }, {grid(30.538955649674413, 218.8615797452521, n)});
    ASSERT_EQ(m.critical.size(), 3u) << n;
    EXPECT_NEAR(m.critical[0].value, 47.6573473, 2e-6);
    EXPECT_NEAR(m.critical[1].value, 111.9662163, 2e-6);
    EXPECT_NEAR(m.critical[2].value, 116.4994953762, 1e-9);
    EXPECT_LE(m.evaluations, 3 * 64);
    // A bracket is true: those of all grids meet.
    if (first.empty()) first = m.critical;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LE(std::max(first[k].lo, m.critical[k].lo), std::min(first[k].hi, m.critical[k].hi)) << n << ": " << k;
      EXPECT_LE(m.critical[k].hi - m.critical[k].lo, 1e-6);
    }
  }
}

}  // namespace
}  // namespace gyromode
