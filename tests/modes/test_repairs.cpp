// What dropped parts do to the roots, as stated, against the roots of the matrices as they were given, in 100 digits.
#include "gyromode/modes/modes.h"
#include "reference/characteristic_root.h"
#include "support/random_matrices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace gyromode {
namespace {

using support::Source;

struct Given {
  Matrix m, g, k;
};

// One of M, G, K departs, by `size` of √(r_i r_j), in some entries or in all.
Given departing(Source& source, Index n, int which, double size, double spin, Index negative) {
  Given a{source.symmetric(n, 0), spin * source.skew(n), source.symmetric(n, negative)};
  Matrix& changed = which == 0 ? a.m : which == 1 ? a.g : a.k;
  const Vector rows = changed.cwiseAbs().rowwise().maxCoeff().cwiseSqrt();
  const bool all = source.integer(0, 1) == 1;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      if (which != 1 && i == j) continue;
      if (all || source.integer(0, 2) == 0) changed(i, j) += size * rows(i) * rows(j) * (source.integer(0, 1) == 1 ? 0.5 : -0.25);
    }
  }
  return a;
}

TEST(Repairs, StatedEffectIsNoLessThanTheTrueOneAndNotTenTimesIt) {
  const char* count = std::getenv("GYROMODE_REPAIRS");
  const int draws = count ? std::atoi(count) : 150;
  Source source{std::mt19937_64(77)};
  int compared = 0;
  double least = 1e300, most = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const Index n = source.integer(2, 6);
    const int which = draw % 3;
    const double size = std::pow(10, -9 - draw % 6), spin = std::pow(10, source.integer(-2, 2));
    const Given a = departing(source, n, which, size, spin, source.integer(0, 3) == 0 ? source.integer(0, n) : 0);
    ModesOptions options;
    const ModesResult r = find_modes(System(a.m, a.g, a.k), options);
    if (r.repairs.empty()) continue;
    ASSERT_EQ(r.repairs.size(), 1U);
    double truth = 0;
    for (const Mode& m : r.modes) truth = std::max(truth, reference::moved_by_asymmetry(a.m, a.g, a.k, Complex(0, m.omega)));
    for (const UnstableMode& u : r.unstable)
      truth = std::max(truth, reference::moved_by_asymmetry(a.m, a.g, a.k, Complex(u.growth_rate, u.omega)));
    const double stated = r.repairs.front().largest_effect.value_or(-1);
    EXPECT_GE(stated, truth) << "draw " << draw << ", n " << n << ", " << r.repairs.front().matrix << ", size " << size << ", spin "
                             << spin;
    EXPECT_LE(stated, 10 * truth) << "draw " << draw << ", n " << n << ", " << r.repairs.front().matrix << ", size " << size << ", spin "
                                  << spin;
    least = std::min(least, stated / truth);
    most = std::max(most, stated / truth);
    ++compared;
  }
  std::printf("%d compared, stated / true from %.9f to %.9f\n", compared, least, most);
  EXPECT_GE(compared, draws / 2);
}

// x and y alike and not coupled by G: λ² = −ω² ± jn, a growth of first order where each mode by itself has none.
TEST(Repairs, DoubleRootsAreTakenTogether) {
  for (const double n : {1e-12, 1e-9}) {
    const ModesResult r = find_modes(System(Matrix::Identity(2, 2), Matrix::Zero(2, 2), Matrix{{4, n}, {-n, 4}}));
    ASSERT_EQ(r.repairs.size(), 1U);
    EXPECT_NEAR(r.repairs.front().largest_effect.value_or(0), n / 4, 1e-3 * n);
  }
}

// Two free coordinates that the dropped part couples: λ² = ±jn. And one free one, coupled to one of stiffness k by n:
// λ² = −(n²/k)(1 + …), of the same order in λ as a first-order effect.
TEST(Repairs, ZeroModesMoveByTheRoot) {
  for (const double n : {1e-12, 1e-9}) {
    Matrix k = Matrix::Zero(3, 3);
    k(2, 2) = 1;
    k(0, 1) = n;
    k(1, 0) = -n;
    const ModesResult r = find_modes(System(Matrix::Identity(3, 3), Matrix::Zero(3, 3), k, {}, {.symmetrise = 1e-6}));
    ASSERT_EQ(r.repairs.size(), 1U);
    EXPECT_NEAR(r.repairs.front().largest_effect.value_or(0), std::sqrt(n), 2e-3 * std::sqrt(n));

    const Matrix one{{0, n}, {-n, 4}};
    const ModesResult s = find_modes(System(Matrix::Identity(2, 2), Matrix::Zero(2, 2), one, {}, {.symmetrise = 1e-6}));
    EXPECT_NEAR(s.repairs.front().largest_effect.value_or(0), n / 2, 1e-3 * n);
  }
}

// A mode that the dropped part couples to a free coordinate below and to a mode above it: both shift it in second
// order, against one another.
TEST(Repairs, ZeroModesShiftTheOthers) {
  for (const double spin : {0.0, 0.5}) {
    Matrix k = Matrix{{0, 0, 0}, {0, 4, 0}, {0, 0, 5}}, g = Matrix::Zero(3, 3);
    const double n = 1e-5;
    k(0, 1) = n, k(1, 0) = -n;
    k(1, 2) = 2 * n, k(2, 1) = -2 * n;
    g(0, 2) = spin, g(2, 0) = -spin;
    ModesOptions options;
    options.window = {1.8, 2.1};
    const ModesResult r = find_modes(System(Matrix::Identity(3, 3), g, k, {}, {.symmetrise = 1e-3}), options);
    ASSERT_EQ(r.modes.size(), 1U);
    const double truth = reference::moved_by_asymmetry(Matrix::Identity(3, 3), g, k, Complex(0, r.modes.front().omega));
    EXPECT_NEAR(r.repairs.front().largest_effect.value_or(0), truth, 2e-3 * truth) << spin;
  }
}

// G of damping, C = c: λ = −c/2 ± jω.
TEST(Repairs, DampingLetsDecay) {
  const double c = 1e-9;
  const ModesResult r = find_modes(System(Matrix{{1}}, Matrix{{c}}, Matrix{{9}}, {}, {.symmetrise = 2}));
  ASSERT_EQ(r.repairs.size(), 1U);
  EXPECT_NEAR(r.repairs.front().largest_effect.value_or(0), c / 2, 1e-3 * c);
  EXPECT_EQ(r.stability, Stability::stable);  // asked for
}

TEST(Repairs, OfFirstOrder) {
  const Matrix inertia{{2, 0}, {0, 1}}, g{{0, 1}, {-1 - 1e-10, 0}};
  const ModesResult r = find_modes(FirstOrderSystem(inertia, g));
  ASSERT_EQ(r.repairs.size(), 1U);
  EXPECT_EQ(r.repairs.front().matrix, "G");
  EXPECT_GT(r.repairs.front().largest_effect.value_or(-1), 0);  // of second order: λ² = −(1 + 1e-10)/2
  EXPECT_LT(r.repairs.front().largest_effect.value_or(1), 1e-18);
}

}  // namespace
}  // namespace gyromode
