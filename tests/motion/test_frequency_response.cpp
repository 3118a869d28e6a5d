#include "gyromode/base/error.h"
#include "gyromode/lapack/small.h"
#include "gyromode/motion/frequency_response.h"
#include "gyromode/modes/modes.h"
#include "support/random_matrices.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace gyromode;
using support::Source;

TEST(FrequencyResponse, SolvesTheImpedance) {
  Source s{std::mt19937_64(1)};
  const System system(s.symmetric(5, 0), s.skew(5), s.symmetric(5, 2));
  const Vector f = s.gaussian(5, 1);
  const Vector grid = Vector::LinSpaced(40, 0, 4);
  const FrequencyResponse r = frequency_response(system, f, grid, false);
  ASSERT_EQ(r.points.size(), 40u);
  for (const FrequencyPoint& p : r.points) {
    ASSERT_FALSE(p.resonance());
    const ComplexVector exact = small::solve_fully_pivoted(system.impedance(p.omega), f.cast<Complex>());
    EXPECT_LE((p.q - exact).norm(), 1e-10 * exact.norm());
  }
}

TEST(FrequencyResponse, ResonanceIsSaidAndShown) {
  const System system(Matrix::Identity(2, 2), Matrix::Zero(2, 2), Matrix{{4, 0}, {0, 9}});
  const FrequencyResponse both = frequency_response(system, Eigen::Vector2d(1, 1), Eigen::Vector3d(1, 2, 4));
  EXPECT_EQ(both.resonances(), (std::vector<double>{2, 3}));
  std::size_t unbounded = 0, added = 0;
  for (const FrequencyPoint& p : both.points) {
    unbounded += p.resonance() ? 1 : 0;
    added += p.added ? 1 : 0;
    EXPECT_EQ(p.resonance(), p.omega == 2);
    if (p.added) {
      EXPECT_GT(p.q.norm(), 5);
    }
  }
  EXPECT_EQ(unbounded, 1u);
  EXPECT_EQ(added, 16u);
  // The second coordinate does not drive the mode at 2: the limit there is finite.
  const FrequencyResponse one = frequency_response(system, Eigen::Vector2d(0, 1), Eigen::Vector3d(1, 2, 4), false);
  EXPECT_FALSE(one.points[1].resonance());
  EXPECT_NEAR(one.points[1].q(1).real(), 0.2, 1e-9);
  EXPECT_NEAR(std::abs(one.points[1].q(0)), 0, 1e-9);
}

// [1 c; c 4] in coordinates with units 2^±30: the mode at 2 has q1 by c/3, and is driven by as much of a force on q1
// for as long as its shape is known so well.
TEST(FrequencyResponse, HowWeaklyAModeIsDriven) {
  for (const double unit : {std::exp2(-30), 1.0, std::exp2(30)}) {
    const Matrix d = Eigen::Vector2d(1, unit).asDiagonal();
    const auto mode_at_two = [&](double c, double f1, double f2) {
      const System system(d * d, Matrix::Zero(2, 2), d * Matrix{{1, c}, {c, 4}} * d);
      const FrequencyResponse r = frequency_response(system, d * Eigen::Vector2d(f1, f2), Eigen::Vector3d(1.5, 2, 2.5), false);
      EXPECT_EQ(r.modes.size(), 1u);
      EXPECT_EQ(r.resonances().size(), r.modes[0].driven == Driven::yes ? 1u : 0u);
      EXPECT_NEAR(r.modes[0].omega, 2, 1e-3);
      return r.modes[0];
    };
    for (const double c : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
      const DrivenMode m = mode_at_two(c, 1, 0);
      EXPECT_EQ(m.driven, Driven::yes) << c << " " << unit;
      EXPECT_NEAR(m.participation, c / 3, 2e-16 + 2e-3 * c / 3) << c << " " << unit;
      EXPECT_EQ(mode_at_two(c, 1e-200, 0).driven, Driven::yes);  // of any size
    }
    for (const double c : {1e-17, 1e-30}) EXPECT_EQ(mode_at_two(c, 1, 0).driven, Driven::undecided) << c;
    EXPECT_EQ(mode_at_two(0, 1, 0).driven, Driven::no);
    EXPECT_EQ(mode_at_two(0, 1, 0).participation, 0);
    EXPECT_EQ(mode_at_two(0, 1, 1e-25).driven, Driven::yes);  // a component of its own, pushed by little: nothing blurs that
    EXPECT_EQ(mode_at_two(0, 0, 0).driven, Driven::no);
    EXPECT_EQ(mode_at_two(0, 0, 3).driven, Driven::yes);
    EXPECT_NEAR(mode_at_two(0, 0, 3).participation, 1, 1e-15);
  }
}

// A ring of three equal masses: rotation of the pair at √3 in itself is nobody's business, the force drives its span.
TEST(FrequencyResponse, EqualFrequenciesAreDrivenAsASpan) {
  const System ring(Matrix::Identity(3, 3), Matrix::Zero(3, 3), Matrix{{3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}});
  const FrequencyResponse r = frequency_response(ring, Eigen::Vector3d(1, 0, 0), Eigen::Vector2d(0.5, 3));
  ASSERT_EQ(r.modes.size(), 3u);
  for (const DrivenMode& m : r.modes) EXPECT_EQ(m.driven, Driven::yes) << m.omega;
  EXPECT_NEAR(r.modes[0].participation, std::sqrt(1.0 / 3), 1e-14);
  EXPECT_NEAR(r.modes[1].participation, std::sqrt(2.0 / 3), 1e-14);
  // symmetric: not the pair, as far as one can tell
  const FrequencyResponse all = frequency_response(ring, Eigen::Vector3d(1, 1, 1), Eigen::Vector2d(0.5, 3));
  EXPECT_EQ(all.modes[0].driven, Driven::yes);
  EXPECT_NE(all.modes[1].driven, Driven::yes);
  EXPECT_EQ(all.resonances().size(), 1u);
}

TEST(FrequencyResponse, RestWhereNothingHolds) {
  const System free(Matrix::Identity(2, 2), Matrix::Zero(2, 2), Matrix{{1, -1}, {-1, 1}});
  EXPECT_TRUE(frequency_response(free, Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)).points[0].resonance());
  EXPECT_FALSE(frequency_response(free, Eigen::Vector2d(1, -1), Eigen::Vector2d(0, 1)).points[0].resonance());
}

TEST(FrequencyResponse, WrongInput) {
  const System system(Matrix::Identity(2, 2), Matrix::Zero(2, 2), Matrix{{4, 0}, {0, 9}});
  EXPECT_THROW(frequency_response(system, Vector::Zero(3), Eigen::Vector2d(1, 2)), InvalidArgument);
  EXPECT_THROW(frequency_response(system, Vector::Zero(2), Eigen::Vector2d(2, 1)), InvalidArgument);
  EXPECT_THROW(frequency_response(system, Vector::Zero(2), Eigen::Vector2d(-1, 1)), InvalidArgument);
}
