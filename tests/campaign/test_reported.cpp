// Small systems on which false claims were made once, each standing for a family; the families are in test_hostile.cpp.
#include "gyromode/modes/modes.h"
#include "gyromode/system/laws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gyromode {
namespace {

Matrix one(Index n) { return Matrix::Identity(n, n); }

std::vector<double> frequencies(const ModesResult& r) {
  std::vector<double> omega;
  for (const Mode& m : r.modes) omega.push_back(m.omega);
  return omega;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& truth, double relative) {
  ASSERT_EQ(found.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_NEAR(found[i], truth[i], relative * truth[i]);
}

ModesResult in_window(const System& s, double a, double b) {
  ModesOptions options;
  options.window = {a, b};
  return find_modes(s, options);
}

// Two roots of the companion matrix are lost below 5e8 · 1e-16; one pair (−, +) and one quadruple look alike to every
// count.
TEST(Reported, StrongSpinWithoutGrowth) {
  const Matrix g = 1e8 * Matrix{{0, 1, 2, 1}, {-1, 0, -3, -2}, {-2, 3, 0, -1}, {-1, 2, 1, 0}};
  const Matrix k{{0, 1, -2, -1}, {1, -2, -1, 0}, {-2, -1, 4, -2}, {-1, 0, -2, 0}};
  const ModesResult r = find_modes(System(one(4), g, k));
  EXPECT_EQ(r.stability, Stability::gyroscopically_stabilised);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << r.coverage.reason;
  EXPECT_TRUE(r.unstable.empty());
  const auto omega = frequencies(r);
  ASSERT_EQ(omega.size(), 4u);
  EXPECT_NEAR(omega[0], 7.237e-9, 1e-12);
  EXPECT_NEAR(omega[1], 0.98869, 1e-5);
  EXPECT_NEAR(omega[2], 1.79513, 1e-5);
  EXPECT_NEAR(omega[3], 4.47e8, 1e6);
}

TEST(Reported, SlowDivergenceUnderSpin) {
  const Matrix g{{0, 4000, 6000}, {-4000, 0, 0}, {-6000, 0, 0}}, k{{2, 0, 0}, {0, 0, -2}, {0, -2, 0}};
  const ModesResult r = find_modes(System(one(3), g, k));
  ASSERT_EQ(r.unstable.size(), 1u);
  EXPECT_NEAR(r.unstable[0].growth_rate, 0.000288675134, 1e-12);
  EXPECT_LE(std::abs(r.unstable[0].growth_rate - 0.000288675134), r.unstable[0].error_bound + 5e-13);
  EXPECT_EQ(r.stability, Stability::unstable);
}

// Two unit masses, springs of stiffness 9 between them in both directions, axes turning at 1 rad/s: modes 1 (double,
// defective), 3.24, 5.24.
System two_masses() {
  Matrix k = -one(4), g = Matrix::Zero(4, 4);
  for (const Index i : {0, 2}) {
    k(i, i) = k(i + 1, i + 1) = 8;
    k(i, i + 1) = k(i + 1, i) = -9;
  }
  g.topRightCorner(2, 2) = -2 * one(2);
  g.bottomLeftCorner(2, 2) = 2 * one(2);
  return System(one(4), g, k);
}

TEST(Reported, WindowsBesideADefectiveRoot) {
  const CountResult two_to_four = count_modes(two_masses(), {2, 4});
  EXPECT_EQ(two_to_four.status, CountStatus::exact);
  EXPECT_EQ(two_to_four.count, 1);
  EXPECT_EQ(two_to_four.window.a, 2);
  EXPECT_EQ(two_to_four.window.b, 4);
  const ModesResult below = in_window(two_masses(), 0, 0.5);
  EXPECT_EQ(below.modes.size(), 0u);
  EXPECT_EQ(below.coverage.window.b, 0.5);
  ModesOptions options;
  options.lowest = 1;
  const ModesResult lowest = find_modes(two_masses(), options);
  ASSERT_EQ(lowest.modes.size(), 2u);  // the pair at 1 comes as one
  for (const Mode& m : lowest.modes) EXPECT_NEAR(m.omega, 1, 1e-6);
}

TEST(Reported, EndsAreMovedNoFartherThanTheEvidenceAsks) {
  const System s(one(2), Matrix{{0, -8}, {8, 0}}, -16 * one(2));  // defective at 4
  const ModesResult r = in_window(s, 0, 1.1);
  EXPECT_EQ(r.coverage.window.b, 1.1);
  EXPECT_EQ(r.modes.size(), 0u);
}

TEST(Reported, GradedSingularStiffness) {
  const Matrix g{{0, 1, 0}, {-1, 0, 1}, {0, -1, 0}};
  const ModesResult r = find_modes(System(one(3), g, Vector{{0, 1, 1e16}}.asDiagonal()));
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << r.coverage.reason;
  const auto omega = frequencies(r);
  ASSERT_EQ(omega.size(), 3u);
  EXPECT_EQ(omega[0], 0);
  EXPECT_NEAR(omega[1], std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(omega[2], 1e8, 1e-6);

  const ModesResult divergent = find_modes(System(one(3), g, Vector{{0, -2, 1e16}}.asDiagonal()));
  ASSERT_EQ(divergent.unstable.size(), 1u);
  EXPECT_NEAR(divergent.unstable[0].growth_rate, 1, 1e-12);
  EXPECT_EQ(divergent.stability, Stability::unstable);
}

// The momentum of the null vector couples with 2³⁴; what K holds beside it must not drown in its square.
TEST(Reported, SingularStiffnessUnderStrongSpin) {
  const double spin = std::ldexp(1.0, 34);
  const Matrix g = spin * Matrix{{0, 1, 2}, {-1, 0, 1}, {-2, -1, 0}}, k{{1, 0, -2}, {0, 4, -4}, {-2, -4, 8}};
  const ModesResult r = find_modes(System(one(3), g, k));
  EXPECT_EQ(r.stiffness.zero, 1);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << r.coverage.reason;
  EXPECT_EQ(r.stability, Stability::stable);
  EXPECT_EQ(r.modes.size(), 3u);
}

TEST(Reported, AVerdictIsWorthWhatItsBalanceIsWorth) {
  const Matrix g = 1e7 * Matrix{{0, -2, 3}, {2, 0, -2}, {-3, 2, 0}}, k{{0, 4, 3}, {4, -2, 2}, {3, 2, 4}};
  const ModesResult r = find_modes(System(one(3), g, k));
  EXPECT_TRUE(r.unstable.empty());
  EXPECT_NE(r.stability, Stability::unstable);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << r.coverage.reason;
}

TEST(Reported, NothingIsThrownAtStrongSpinOrHugeNumbers) {
  const Matrix g = 1e7 * Matrix{{0, -2, 1}, {2, 0, -2}, {-1, 2, 0}}, k{{0, 0, 0}, {0, -2, 2}, {0, 2, -2}};
  EXPECT_NO_THROW(find_modes(System(one(3), g, k)));
  const System huge(one(2), Matrix{{0, -1e300}, {1e300, 0}}, one(2));
  EXPECT_NO_THROW(find_modes(huge));
  const System plain(one(2), Matrix{{0, -1}, {1, 0}}, one(2));
  for (const double end : {1e155, 1e300, 5e-324, 1e-200}) {
    const ModesResult r = in_window(plain, 0, end);
    EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << end << ": " << r.coverage.reason;
    EXPECT_EQ(r.modes.size(), end > 1 ? 2u : 0u);
  }
}

TEST(Reported, ADoubleDivergentPairIsNoFlutter) {
  Matrix k = Matrix::Zero(4, 4), g = Matrix::Zero(4, 4);
  const Matrix k1{{-3, 1}, {1, -2}}, g1{{0, 0.5}, {-0.5, 0}};
  k.topLeftCorner(2, 2) = k.bottomRightCorner(2, 2) = k1;
  g.topLeftCorner(2, 2) = g.bottomRightCorner(2, 2) = g1;
  const Matrix u{{1, 0, 1, 0}, {0, 1, 1, 1}, {0, 0, 1, 2}, {0, 0, 0, 1}};
  const ModesResult r = find_modes(System(u.transpose() * u, u.transpose() * g * u, u.transpose() * k * u));
  EXPECT_EQ(r.unstable.size(), 4u);
  for (const UnstableMode& m : r.unstable) EXPECT_FALSE(m.flutter());
}

// Avoidable refusals.
TEST(Reported, WellConditionedSystemsAreCertified) {
  const ModesResult a =
      find_modes(System(one(3), Matrix{{0, 3, -3}, {-3, 0, -2}, {3, 2, 0}}, Matrix{{-4, 2, -4}, {2, -2, -2}, {-4, -2, -2}}));
  EXPECT_EQ(a.coverage.status, CoverageStatus::complete) << a.coverage.reason;
  EXPECT_TRUE(std::any_of(a.modes.begin(), a.modes.end(), [](const Mode& m) { return std::abs(m.omega - std::sqrt(18.0)) < 1e-12; }));

  const Matrix m{{1, 0, -1, 0}, {0, 2, 0, -3}, {-1, 0, 2, 0}, {0, -3, 0, 5}}, g{{0, 0, -2, 0}, {0, 0, 0, -2}, {2, 0, 0, 0}, {0, 2, 0, 0}},
      k{{1, -2, -1, 2}, {-2, 2, 4, -3}, {-1, 4, 2, -6}, {2, -3, -6, 5}};
  const ModesResult b = find_modes(System(m, g, k));
  EXPECT_TRUE(b.index_balance.closed) << b.coverage.reason;
  EXPECT_EQ(b.coverage.status, CoverageStatus::complete) << b.coverage.reason;
}

// Coordinates in units 2^±20: windows of first-order models stay where they are asked. A free ring of m masses in its
// plane, in axes that turn with it at Ω = 1, its springs drawn by the centrifugal force: one zero mode (rotation), and
// a defective double root at Ω (translation in axes at rest).
System free_ring(Index m, double stiffness) {
  const double pi = std::acos(-1.0), mass = 1.0 / static_cast<double>(m), tension = mass / (2 * std::sin(pi / static_cast<double>(m)));
  const auto place = [&](Index i) {
    return Eigen::Vector2d(std::cos(2 * pi * static_cast<double>(i) / static_cast<double>(m)),
                           std::sin(2 * pi * static_cast<double>(i) / static_cast<double>(m)));
  };
  Matrix k = Matrix::Zero(2 * m, 2 * m), g = Matrix::Zero(2 * m, 2 * m);
  const auto spring = [&](Index i, Index j, double along, double pull) {
    const Eigen::Vector2d d = place(j) - place(i), u = d.normalized();
    const Eigen::Matrix2d b = along * u * u.transpose() + pull / d.norm() * (Eigen::Matrix2d::Identity() - u * u.transpose());
    k.block<2, 2>(2 * i, 2 * i) += b;
    k.block<2, 2>(2 * j, 2 * j) += b;
    k.block<2, 2>(2 * i, 2 * j) -= b;
    k.block<2, 2>(2 * j, 2 * i) -= b;
  };
  for (Index i = 0; i < m; ++i) {
    spring(i, (i + 1) % m, stiffness, tension);
    spring(i, (i + 2) % m, 0.5 * stiffness, 0);
    g(2 * i + 1, 2 * i) = 2 * mass;
    g(2 * i, 2 * i + 1) = -2 * mass;
  }
  return System(mass * one(2 * m), g, symmetric_part(k - mass * one(2 * m)));
}

TEST(Reported, FreeRingsInTurningAxes) {
  for (const Index m : {10, 20, 40, 60, 80, 160}) {
    for (const double stiffness : {1.0, 100.0}) {
      const ModesResult r = find_modes(free_ring(m, stiffness));
      EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << m << ": " << r.coverage.reason;
      EXPECT_EQ(r.stability, Stability::marginal) << m;
      EXPECT_TRUE(r.unstable.empty()) << m;
      EXPECT_EQ(std::count_if(r.modes.begin(), r.modes.end(), [](const Mode& mode) { return mode.omega == 0; }), 1) << m;
      EXPECT_EQ(std::count_if(
                    r.modes.begin(), r.modes.end(),
                    [](const Mode& mode) { return std::abs(mode.omega - 1) <= std::min(mode.error_bound, 1e-3) && mode.energy_sign == 0; }),
                2)
          << m;
    }
  }
}

TEST(Reported, MixedUnitsOfFirstOrder) {
  const Matrix inertia = Matrix{{2, 1, 0, 0}, {1, 3, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 2}},
               g{{0, 1, 4, 0}, {-1, 0, 2, 3}, {-4, -2, 0, 1}, {0, -3, -1, 0}};
  const ModesResult plain = find_modes(FirstOrderSystem(inertia, g));
  Vector unit{{std::ldexp(1.0, 20), std::ldexp(1.0, -20), 1, std::ldexp(1.0, 13)}};
  const FirstOrderSystem mixed(unit.asDiagonal() * inertia * unit.asDiagonal(), unit.asDiagonal() * g * unit.asDiagonal());
  const ModesResult r = find_modes(mixed);
  expect_near(frequencies(r), frequencies(plain), 0);  // the same system, to the last bit
  const CountResult c = count_modes(mixed, {0.5 * plain.modes.back().omega, 2 * plain.modes.back().omega});
  EXPECT_EQ(c.status, CountStatus::exact);
  EXPECT_EQ(c.window.b, 2 * plain.modes.back().omega);
}

// Units of time and of every coordinate: answers transform exactly, flutter stays flutter.
TEST(Reported, MixedUnitsOfSecondOrder) {
  const Matrix m{{2, 1, 0}, {1, 2, 0}, {0, 0, 1}}, g{{0, 2, 1}, {-2, 0, 3}, {-1, -3, 0}}, k{{-3, 1, 0}, {1, -2, 1}, {0, 1, -4}};
  const ModesResult plain = find_modes(System(m, g, k));
  for (const int time : {-30, 0, 30}) {
    const Vector unit{{std::ldexp(1.0, 30), std::ldexp(1.0, -30), std::ldexp(1.0, -7)}};
    const double t = std::ldexp(1.0, time);
    const ModesResult r = find_modes(System(unit.asDiagonal() * m * unit.asDiagonal(), t * (unit.asDiagonal() * g * unit.asDiagonal()),
                                            t * t * (unit.asDiagonal() * k * unit.asDiagonal())));
    EXPECT_EQ(r.stability, plain.stability);
    ASSERT_EQ(r.modes.size(), plain.modes.size());
    for (std::size_t i = 0; i < r.modes.size(); ++i) EXPECT_EQ(r.modes[i].omega, t * plain.modes[i].omega);
    ASSERT_EQ(r.unstable.size(), plain.unstable.size());
    for (std::size_t i = 0; i < r.unstable.size(); ++i) EXPECT_EQ(r.unstable[i].growth_rate, t * plain.unstable[i].growth_rate);
  }
}

}  // namespace
}  // namespace gyromode
