#include "gyromode/motion/frequency_response.h"
#include "gyromode/modes/modes.h"
#include "support/random_matrices.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

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
    ASSERT_FALSE(p.resonance);
    const ComplexVector exact = system.impedance(p.omega).fullPivLu().solve(f.cast<Complex>());
    EXPECT_LE((p.q - exact).norm(), 1e-10 * exact.norm());
  }
}

TEST(FrequencyResponse, ResonanceIsSaidAndShown) {
  const System system(Matrix::Identity(2, 2), Matrix::Zero(2, 2), Matrix{{4, 0}, {0, 9}});
  const FrequencyResponse both = frequency_response(system, Eigen::Vector2d(1, 1), Eigen::Vector3d(1, 2, 4));
  EXPECT_EQ(both.resonances, (std::vector<double>{2, 3}));
  std::size_t unbounded = 0, added = 0;
  for (const FrequencyPoint& p : both.points) {
    unbounded += p.resonance ? 1 : 0;
    added += p.added ? 1 : 0;
    EXPECT_EQ(p.resonance, p.omega == 2);
    if (p.added) { EXPECT_GT(p.q.norm(), 5); }
  }
  EXPECT_EQ(unbounded, 1u);
  EXPECT_EQ(added, 16u);
  // The second coordinate does not drive the mode at 2: the limit there is finite.
  const FrequencyResponse one = frequency_response(system, Eigen::Vector2d(0, 1), Eigen::Vector3d(1, 2, 4), false);
  EXPECT_FALSE(one.points[1].resonance);
  EXPECT_NEAR(one.points[1].q(1).real(), 0.2, 1e-9);
  EXPECT_NEAR(std::abs(one.points[1].q(0)), 0, 1e-9);
}

TEST(FrequencyResponse, RestWhereNothingHolds) {
  const System free(Matrix::Identity(2, 2), Matrix::Zero(2, 2), Matrix{{1, -1}, {-1, 1}});
  EXPECT_TRUE(frequency_response(free, Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)).points[0].resonance);
  EXPECT_FALSE(frequency_response(free, Eigen::Vector2d(1, -1), Eigen::Vector2d(0, 1)).points[0].resonance);
}

TEST(FrequencyResponse, WrongInput) {
  const System system(Matrix::Identity(2, 2), Matrix::Zero(2, 2), Matrix{{4, 0}, {0, 9}});
  EXPECT_THROW(frequency_response(system, Vector::Zero(3), Eigen::Vector2d(1, 2)), std::invalid_argument);
  EXPECT_THROW(frequency_response(system, Vector::Zero(2), Eigen::Vector2d(2, 1)), std::invalid_argument);
  EXPECT_THROW(frequency_response(system, Vector::Zero(2), Eigen::Vector2d(-1, 1)), std::invalid_argument);
}
