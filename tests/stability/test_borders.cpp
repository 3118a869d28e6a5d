// Borders between verdicts along a line, where verdicts beside them are missing, noise, or open: as many as there are,
// in a bounded number of evaluations.
#include "gyromode/stability/border.h"
#include "gyromode/stability/stability_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <random>

namespace gyromode {
namespace {

StabilityPoint said(Stability s, bool closed = true, Index divergent = 0) {
  StabilityPoint p;
  p.stability = s;
  p.balance.closed = closed;
  p.balance.real_pairs = divergent;
  return p;
}
const StabilityPoint stable = said(Stability::stable), unstable = said(Stability::unstable),
                     stabilised = said(Stability::gyroscopically_stabilised), marginal = said(Stability::marginal),
                     unknown = said(Stability::unknown, false), no_model{false, Stability::unknown, {}, 0, "no such model"};

// A number from 0 to 1 that has nothing to do with x but is one for each.
double chance(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  std::mt19937_64 engine(bits);
  return std::uniform_real_distribution<double>(0, 1)(engine);
}

std::vector<double> grid(double a, double b, int n) {
  std::vector<double> x;
  for (int k = 0; k < n; ++k) x.push_back(k + 1 == n ? b : a + (b - a) * k / (n - 1));
  return x;
}

using Line = std::function<StabilityPoint(double)>;
StabilityMap along(const Line& line, double a, double b, int n) {
  return map_stability([&](const std::vector<double>& v) { return line(v[0]); }, {grid(a, b, n)});
}

// One border at 1/3, whatever the grid and whatever surrounds it within `width`.
void expect_one(const Line& line, double width, const StabilityPoint& from, const StabilityPoint& to, const char* what) {
  constexpr double at = 1.0 / 3;
  for (const int n : {2, 3, 4, 7, 13, 31, 100}) {
    const StabilityMap m = along(line, 0, 1, n);
    ASSERT_EQ(m.critical.size(), 1u) << what << ", width " << width << ", grid " << n;
    const CriticalValue& c = m.critical[0];
    EXPECT_NEAR(c.value, at, width + 1e-14) << what;
    EXPECT_LE(c.lo, c.value);
    EXPECT_GE(c.hi, c.value);
    EXPECT_LE(c.hi - c.lo, 2 * width / (1 - 2 * BorderSearch::of_band) * (1 + 1e-9) + 2e-14) << what;
    EXPECT_EQ(c.from.stability, from.stability);
    EXPECT_EQ(c.to.stability, to.stability);
    EXPECT_LE(m.evaluations, 2 * BorderSearch::most_evaluations) << what << ", width " << width << ", grid " << n;
  }
}

TEST(Borders, OfTwoVerdicts) {
  expect_one([](double x) { return x < 1.0 / 3 ? stable : unstable; }, 0, stable, unstable, "sharp");
}

// Without a verdict within `width` of the border, on both sides or on one.
TEST(Borders, ABandWithoutAVerdictIsNone) {
  for (const StabilityPoint& nothing : {unknown, no_model}) {
    for (const double width : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.03, 0.2}) {
      for (const auto& [below, above] : {std::pair(1.0, 1.0), {1.0, 0.0}, {0.0, 1.0}}) {
        expect_one(
            [&, below = below, above = above](double x) {
              const double d = x - 1.0 / 3;
              return d > -below * width && d < above * width ? nothing : d < 0 ? stabilised : unstable;
            },
            width, stabilised, unstable, "band");
      }
    }
  }
}

TEST(Borders, BandsWithinOneVerdictAreNone) {
  for (const double width : {1e-12, 1e-3, 0.1, 0.3}) {
    for (const int n : {2, 3, 4, 7, 13, 31, 100}) {
      EXPECT_TRUE(along([&](double x) { return std::abs(x - 1.0 / 3) < width ? unknown : unstable; }, 0, 1, n).critical.empty());
      EXPECT_TRUE(along([&](double x) { return x < width ? unknown : unstable; }, 0, 1, n).critical.empty());
    }
  }
  EXPECT_TRUE(along([](double) { return unknown; }, 0, 1, 5).critical.empty());
  EXPECT_TRUE(along([](double x) { return x < 0.5 ? unknown : no_model; }, 0, 1, 5).critical.empty());
}

// Rounding beside a border: verdicts at random, of the two, of a third, or none.
TEST(Borders, NoiseBesideABorder) {
  for (const double width : {1e-15, 1e-13, 1e-11, 1e-9}) {
    expect_one(
        [&](double x) {
          const double d = x - 1.0 / 3;
          if (std::abs(d) > width) return d < 0 ? stable : unstable;
          const double c = chance(x);
          return c < 0.3 ? stable : c < 0.6 ? unstable : c < 0.8 ? marginal : unknown;
        },
        width, stable, unstable, "noise");
    expect_one(
        [&](double x) {
          const double d = x - 1.0 / 3;
          if (std::abs(d) > width) return said(Stability::unstable, true, d < 0 ? 1 : 2);
          return said(Stability::unstable, chance(x) < 0.5, static_cast<Index>(6 * chance(2 * x)));
        },
        width, unstable, unstable, "noise of numbers");
  }
}

// Wide noise is bounded as well: no more evaluations than one border may take, and no more borders than evaluations.
TEST(Borders, WideNoiseIsBounded) {
  for (const double width : {1e-6, 1e-3, 0.1}) {
    const StabilityMap m = along(
        [&](double x) {
          const double d = x - 1.0 / 3;
          return std::abs(d) > width ? (d < 0 ? stable : unstable) : said(Stability::unstable, true, static_cast<Index>(6 * chance(x)));
        },
        0, 1, 2);
    EXPECT_LE(m.evaluations, BorderSearch::most_evaluations);
    EXPECT_GE(m.critical.size(), 1u);
    EXPECT_NEAR(m.critical.front().lo, 1.0 / 3 - width, 2 * width);
  }
}

TEST(Borders, ThirdVerdictsBetween) {
  for (const int n : {2, 3, 5, 50}) {
    const StabilityMap m =
        along([](double x) { return x < 0.31   ? stable
                                    : x < 0.43 ? unstable
                                    : x < 0.77 ? stabilised
                                               : marginal; }, 0, 1, n);
    ASSERT_EQ(m.critical.size(), 3u) << n;
    EXPECT_NEAR(m.critical[0].value, 0.31, 1e-13);
    EXPECT_NEAR(m.critical[1].value, 0.43, 1e-13);
    EXPECT_NEAR(m.critical[2].value, 0.77, 1e-13);
  }
}

// `unstable` with an open balance says no more than that.
TEST(Borders, OpenBalances) {
  const auto line = [](double x) {
    if (x < 0.2) return stable;
    if (chance(x) < 0.4) return said(Stability::unstable, false, 0);
    return said(Stability::unstable, true, x < 0.6 ? 1 : 2);
  };
  for (const int n : {4, 7, 30}) {
    const StabilityMap m = along(line, 0.01, 0.99, n);
    ASSERT_EQ(m.critical.size(), 2u) << n;
    EXPECT_NEAR(m.critical[0].value, 0.2, 1e-13);
    EXPECT_NEAR(m.critical[1].value, 0.6, 0.01);
    EXPECT_LE(m.critical[1].lo, 0.6);
    EXPECT_GE(m.critical[1].hi, 0.6);
  }
  // Never closed, and yet two borders.
  const StabilityMap m = along([](double x) { return x < 0.2 || x > 0.7 ? stable : said(Stability::unstable, false); }, 0, 1, 11);
  ASSERT_EQ(m.critical.size(), 2u);
  EXPECT_NEAR(m.critical[1].value, 0.7, 1e-13);
}

}  // namespace
}  // namespace gyromode
