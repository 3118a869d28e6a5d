// Windows, their ends, the lowest so many, coverage and counts are written once, on CountedSpectrum: here an engine
// that answers from closed form, a taut string between fixed ends, ω_k = kπ, and one that loses a root.
#include "gyromode/base/error.h"
#include "gyromode/certificate/coverage.h"
#include "gyromode/modes/answer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gyromode {
namespace {

constexpr double pi = std::numbers::pi;

class String : public CountedSpectrum {
 public:
  explicit String(Index lost = 0) : lost_(lost) {}

  RootRange roots(const Window& range, const Progress& = {}) const override {
    RootRange r;
    for (Index k = 1; static_cast<double>(k) * pi < range.b; ++k) {
      const double omega = static_cast<double>(k) * pi;
      if (omega >= range.a && k != lost_) r.roots.push_back({omega, omega * epsilon, 1, false, false, ""});
    }
    r.mode = [roots = r.roots](std::size_t i, bool) {
      Mode m;
      m.omega = roots[i].omega;
      return m;
    };
    return r;
  }
  bool finite() const override { return false; }
  double above_all() const override { return infinity; }
  double reach() const override { return 1000 * pi; }
  std::string reach_reason() const override { return "a string is thinner than that"; }
  Index below(double omega) const override { return omega <= 0 ? 0 : static_cast<Index>(std::ceil(omega / pi)) - 1; }
  Index missed_by_signs(const Window&) const override { return 0; }
  Index zero_roots() const override { return 0; }
  Inertia inertia_at(double omega) const override {
    Inertia i;
    i.negative = below(omega);
    i.margin = std::abs(omega / pi - std::round(omega / pi)) > 1e-12 ? 1 : 0;
    return i;
  }
  Index negative_at_zero() const override { return 0; }
  IndexBalance balance() const override { return {}; }
  std::string open_reason() const override { return ""; }
  bool isolated() const override { return true; }
  void describe(ModesResult& r, bool) const override { r.stability = Stability::stable; }

 private:
  Index lost_;
};

ModesOptions window(double a, double b) {
  ModesOptions o;
  o.window = {a, b};
  return o;
}

TEST(CountedSpectrum, AWindowIsCounted) {
  const ModesResult r = modes_of(String(), window(2, 10));
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << r.coverage.reason;
  ASSERT_EQ(r.modes.size(), 3u);
  EXPECT_EQ(r.modes[2].omega, 3 * pi);
  EXPECT_EQ(r.coverage.window.a, 2);  // an end that was not moved is exactly the one asked for
  EXPECT_EQ(r.coverage.window.b, 10);
}

TEST(CountedSpectrum, AnEndOnARootIsMovedOutward) {
  const ModesResult r = modes_of(String(), window(pi, 3 * pi));
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << r.coverage.reason;
  EXPECT_EQ(r.modes.size(), 3u);
  EXPECT_LT(r.coverage.window.a, pi);
  EXPECT_GT(r.coverage.window.b, 3 * pi);
  EXPECT_NEAR(r.coverage.window.b, 3 * pi, 1e-10);
  EXPECT_EQ(r.coverage.requested.b, 3 * pi);
}

TEST(CountedSpectrum, TheLowestAreThoseBelowTheNextGap) {
  ModesOptions o;
  o.lowest = 4;
  const ModesResult r = modes_of(String(), o);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
  EXPECT_EQ(r.modes.size(), 4u);
  EXPECT_NEAR(r.coverage.window.b, 4.5 * pi, 1e-12);
}

TEST(CountedSpectrum, ALostRootIsNotCalledComplete) {
  const ModesResult r = modes_of(String(2), window(1, 10));
  EXPECT_EQ(r.coverage.status, CoverageStatus::incomplete);
  EXPECT_EQ(r.coverage.found, 2);
  EXPECT_EQ(r.coverage.counted, 3);
}

TEST(CountedSpectrum, CountsNeedNoRoots) {
  const CountResult c = count_of(String(2), {1, 100 * pi + 1});
  EXPECT_EQ(c.status, CountStatus::exact);
  EXPECT_EQ(c.count, 100);
}

TEST(CountedSpectrum, OfInfinitelyManyAnEndIsNeeded) {
  EXPECT_THROW(modes_of(String(), window(0, infinity)), InvalidArgument);
  EXPECT_THROW(count_of(String(), {0, infinity}), InvalidArgument);
}

TEST(CountedSpectrum, BeyondReachIsRefusedWithTheReason) {
  ModesOptions o;
  o.lowest = 2000;
  try {
    modes_of(String(), o);
    FAIL();
  } catch (const InvalidArgument& e) {
    EXPECT_NE(std::string(e.what()).find("thinner"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace gyromode
