// A system seen from some of its coordinates: the condensed impedance has the same count, and modes that leave the kept
// coordinates at rest are named, however they coincide with others.
#include "gyromode/dense/inertia.h"
#include "gyromode/modes/keep.h"

#include "support/random_matrices.h"
#include "support/random_system.h"

#include <gtest/gtest.h>

namespace gyromode {
namespace {

// A hub (kept, mass 3) with four equal springs-and-masses around it: one pattern moves the hub, three leave it at rest,
// at ω = √(k/m) = 2.
System hub_with_four_equal_masses(double detuning = 0) {
  Matrix m = Matrix::Identity(5, 5), k = Matrix::Zero(5, 5);
  m(0, 0) = 3;
  k(0, 0) = 1;
  for (Index i = 1; i < 5; ++i) {
    const double stiffness = 4 * (1 + (i == 1 ? detuning : 0));
    k(i, i) += stiffness;
    k(0, 0) += stiffness;
    k(0, i) = k(i, 0) = -stiffness;
  }
  return System(m, Matrix::Zero(5, 5), k, {"hub", "a", "b", "c", "d"});
}

Index locals(const ModesResult& r) {
  return std::count_if(r.modes.begin(), r.modes.end(), [](const Mode& m) { return m.kind == ModeKind::local; });
}

TEST(Keep, PatternsThatLeaveTheHubAtRestAreLocal) {
  ModesOptions options;
  options.shapes = true;
  const ModesResult r = find_modes_keeping(hub_with_four_equal_masses(), {0}, options);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
  EXPECT_EQ(locals(r), 3);
  for (const Mode& m : r.modes) {
    if (m.kind == ModeKind::local) {
      EXPECT_NEAR(m.omega, 2, 1e-14);
      EXPECT_EQ(m.shape(0), 0.0);
      EXPECT_NEAR(std::abs(m.shape.sum()), 0, 1e-12) << "no force on the hub";
    } else {
      EXPECT_GT(std::abs(m.shape(0)), 0.01);
    }
  }
}

// A detuning far above rounding makes one of the three move the hub, however little.
TEST(Keep, AWeakPartIsNoRest) {
  EXPECT_EQ(locals(find_modes_keeping(hub_with_four_equal_masses(1e-9), {0}, {})), 2);
  EXPECT_EQ(locals(find_modes_keeping(hub_with_four_equal_masses(1e-3), {0}, {})), 2);
}

TEST(Keep, CondensedCountsAreThoseOfTheWhole) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const System s = support::random_system(seed).system();
    if (s.size() < 3) continue;
    const std::vector<Index> kept{0, s.size() - 1};
    for (const double omega : {0.3, 1.1, 2.9}) {
      const ReducedImpedance r = reduced_impedance(s, kept, omega);
      const Inertia whole = inertia(s.impedance(omega));
      if (whole.doubtful() || r.internal.doubtful() || r.kept.doubtful()) continue;
      EXPECT_EQ(r.internal.negative + r.kept.negative, whole.negative) << seed;
      ++compared;
    }
    // Frequencies are those without --keep.
    const ModesResult all = find_modes(s), seen = find_modes_keeping(s, kept, {});
    ASSERT_EQ(all.modes.size(), seen.modes.size());
    for (std::size_t i = 0; i < all.modes.size(); ++i) EXPECT_EQ(all.modes[i].omega, seen.modes[i].omega);
  }
  EXPECT_GE(compared, 500u);
}

}  // namespace
}  // namespace gyromode
