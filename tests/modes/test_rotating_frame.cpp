// The rotating-frame family at sizes up to 2000: frequencies |ω_k − Ω|, ω_k + Ω exactly, energy signs, counts and zero modes, with K from positive to
// negative definite.
#include "analytic/closed_forms.h"

#include "gyromode/modes/modes.h"
#include "gyromode/system/scale.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace gyromode {
namespace {

struct Truth {
  double omega;
  int sign;
};

// M₀ = 1 and K₀ = Q diag(ω_k²) Qᵀ: ω_k is known exactly up to the rounding of K₀, which is a backward error of n ε ‖K₀‖.
struct Family {
  Vector omega;
  analytic::RotatingFrame frame;

  std::vector<Truth> truth() const {
    std::vector<Truth> t;
    for (const double w : omega) {
      if (w != frame.spin) t.push_back({std::abs(w - frame.spin), w < frame.spin ? -1 : 1});
      t.push_back({w + frame.spin, 1});
    }
    std::sort(t.begin(), t.end(), [](const Truth& a, const Truth& b) { return a.omega < b.omega; });
    return t;
  }
};

Family family(Index half, double spin, unsigned seed, bool spin_at_a_frequency = false) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Matrix a(half, half);
  for (double& x : a.reshaped()) x = normal(random);
  const Matrix q = Eigen::HouseholderQR<Matrix>(a).householderQ() * Matrix::Identity(half, half);
  Family f;
  f.omega.resize(half);
  for (Index i = 0; i < half; ++i) f.omega(i) = 1 + 9 * (static_cast<double>(i) + 0.3) / static_cast<double>(half);
  f.frame.spin = spin_at_a_frequency ? f.omega(half / 3) : spin;
  f.frame.mass = Matrix::Identity(half, half);
  f.frame.stiffness = symmetric_part(q * f.omega.cwiseAbs2().asDiagonal() * q.transpose());
  return f;
}

// |δω| ≤ 30 n ε (‖K‖ + ω‖G‖ + ω²‖M‖)‖X‖² / |Xᴴ(2ωM − jG)X|; here |Xᴴ(2ωM − jG)X| = 2ω_k‖X‖² with ω_k = ω ± Ω.
void expect_truth(const Family& f, const ModesResult& r) {
  const System s = f.frame.system();
  const double n = static_cast<double>(s.size());
  const double norms[] = {norm1(s.stiffness()), norm1(s.gyroscopic()), norm1(s.mass())};
  const std::vector<Truth> truth = f.truth();
  std::vector<const Mode*> vibrations;
  for (const Mode& m : r.modes) {
    if (m.omega > 0) vibrations.push_back(&m);
  }
  ASSERT_EQ(vibrations.size(), truth.size());
  double worst = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double w = truth[i].omega;
    const double at_rest = truth[i].sign < 0 ? f.frame.spin - w : std::max(w - f.frame.spin, std::abs(f.frame.spin + truth[i].sign * w));
    const double allowed = n * 2.22e-16 * (norms[0] + w * norms[1] + w * w * norms[2]) / (2 * std::min(at_rest, w + f.frame.spin));
    worst = std::max(worst, std::abs(vibrations[i]->omega - w) / allowed);
  }
  EXPECT_LE(worst, 30);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << r.coverage.reason;
}

void expect_signs(const Family& f, const ModesResult& r) {
  Index expected = 0;
  for (const Truth& t : f.truth()) expected += t.sign < 0 ? 1 : 0;
  Index negative = 0;
  for (const Mode& m : r.modes) negative += m.energy_sign < 0 ? 1 : 0;
  EXPECT_EQ(negative, expected);
  EXPECT_EQ(r.index_balance.negative_energy, expected);
}

class RotatingFrameAtSpin : public testing::TestWithParam<std::tuple<Index, double>> {};

TEST_P(RotatingFrameAtSpin, FrequenciesSignsAndCount) {
  const auto [half, spin] = GetParam();
  const Family f = family(half, spin, 7);
  const ModesResult r = find_modes(f.frame.system());
  expect_truth(f, r);
  expect_signs(f, r);
  EXPECT_EQ(r.stability, spin < f.omega(0) ? Stability::stable : Stability::gyroscopically_stabilised);
}
// Ω = 0, below, among and above all ω_k (1 … 10)
INSTANTIATE_TEST_SUITE_P(Spins, RotatingFrameAtSpin,
                         testing::Combine(testing::Values(3, 20, 100), testing::Values(0.0, 0.5, 0.99, 3.25123, 7.0517, 10.5, 40.0)));
INSTANTIATE_TEST_SUITE_P(Large, RotatingFrameAtSpin, testing::Values(std::tuple{Index{500}, 0.5}, std::tuple{Index{500}, 12.0}));

TEST(RotatingFrame, ZeroModeWhereTheSpinMeetsAFrequency) {
  for (const Index half : {3, 20, 100}) {
    const Family f = family(half, 0, 11, true);
    const ModesResult r = find_modes(f.frame.system());
    EXPECT_EQ(r.index_balance.zero, 1);
    EXPECT_EQ(r.modes[0].omega, 0);
    expect_truth(f, r);
    EXPECT_EQ(r.stability, half / 3 == 0 ? Stability::stable : Stability::marginal);
  }
}

// The full size takes half a minute: asked for with GYROMODE_RANDOM_SYSTEMS of 100000 or more (./check --full).
TEST(RotatingFrame, TwoThousandCoordinates) {
  const char* asked = std::getenv("GYROMODE_RANDOM_SYSTEMS");
  if (!asked || std::atol(asked) < 100000) GTEST_SKIP() << "only with ./check --full";
  for (const double spin : {0.0, 0.5, 5.4321, 12.0}) {
    const Family f = family(1000, spin, 3);
    const ModesResult r = find_modes(f.frame.system());
    expect_truth(f, r);
    expect_signs(f, r);
  }
}

}  // namespace
}  // namespace gyromode
