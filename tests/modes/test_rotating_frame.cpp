// The rotating-frame family at sizes up to 2000: frequencies |ω_k − Ω|, ω_k + Ω exactly, energy signs, counts and zero
// modes, with K from positive to negative definite.
#include "analytic/closed_forms.h"

#include "gyromode/lapack/small.h"
#include "gyromode/modes/modes.h"
#include "gyromode/system/scale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

namespace gyromode {
namespace {

struct Truth {
  double omega;
  int sign;
};

// M₀ = R Rᵀ of the given condition and K₀ = R Q diag(ω_k²) Qᵀ Rᵀ: ω_k is known exactly up to the rounding of M₀ and K₀,
// which is a backward error of n ε ‖K₀‖.
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

Matrix random_orthogonal(Index n, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Matrix a(n, n);
  for (double& x : a.reshaped()) x = normal(random);
  return small::orthogonal_factor(a);
}

struct Options {
  bool spin_at_a_frequency = false;
  double mass_condition = 1;
};

Family family(Index half, double spin, unsigned seed, const Options& options = {}) {
  std::mt19937_64 random(seed);
  const Matrix q = random_orthogonal(half, random);
  const Vector grades = Vector::LinSpaced(half, 0, -0.5 * std::log(options.mass_condition)).array().exp();
  const Matrix root =
      options.mass_condition == 1 ? Matrix::Identity(half, half) : Matrix(random_orthogonal(half, random) * grades.asDiagonal());
  Family f;
  f.omega.resize(half);
  for (Index i = 0; i < half; ++i) f.omega(i) = 1 + 9 * (static_cast<double>(i) + 0.3) / static_cast<double>(half);
  f.frame.spin = options.spin_at_a_frequency ? f.omega(half / 3) : spin;
  f.frame.mass = symmetric_part(root * root.transpose());
  const Matrix rq = root * q;
  f.frame.stiffness = symmetric_part(rq * f.omega.cwiseAbs2().asDiagonal() * rq.transpose());
  return f;
}

ModesResult with_shapes(const Family& f) {
  ModesOptions options;
  options.shapes = true;
  return find_modes(f.frame.system(), options);
}

// |δω| ≤ 30 n ε (‖K‖ + ω‖G‖ + ω²‖M‖)‖X‖² / |Xᴴ(2ωM − jG)X|.
double allowed(const System& s, double omega, const ComplexVector& x) {
  const double size = norm1(s.stiffness()) + omega * norm1(s.gyroscopic()) + omega * omega * norm1(s.mass());
  const ComplexMatrix form = 2 * omega * s.mass().cast<Complex>() - Complex(0, 1) * s.gyroscopic().cast<Complex>();
  return 30 * static_cast<double>(s.size()) * std::numeric_limits<double>::epsilon() * size * x.squaredNorm() / std::abs(x.dot(form * x));
}

void expect_truth(const Family& f, const ModesResult& r) {
  const System s = f.frame.system();
  const std::vector<Truth> truth = f.truth();
  std::vector<const Mode*> vibrations;
  for (const Mode& m : r.modes) {
    if (m.omega > 0) vibrations.push_back(&m);
  }
  ASSERT_EQ(vibrations.size(), truth.size());
  double worst = 0;
  const std::size_t step = 1 + truth.size() / 200;  // the bound costs a product with M and G: of the large ones not for every mode
  for (std::size_t i = 0; i < truth.size(); i += step) {
    worst = std::max(worst, std::abs(vibrations[i]->omega - truth[i].omega) / allowed(s, truth[i].omega, vibrations[i]->shape));
  }
  EXPECT_LE(worst, 1);
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
  const ModesResult r = with_shapes(f);
  expect_truth(f, r);
  expect_signs(f, r);
  EXPECT_EQ(r.stability, spin < f.omega(0) ? Stability::stable : Stability::gyroscopically_stabilised);
}
// Ω = 0, below, among and above all ω_k (1 … 10)
INSTANTIATE_TEST_SUITE_P(Spins, RotatingFrameAtSpin,
                         testing::Combine(testing::Values(3, 20, 100), testing::Values(0.0, 0.5, 0.99, 3.25123, 7.0517, 10.5, 40.0)));
INSTANTIATE_TEST_SUITE_P(Large, RotatingFrameAtSpin, testing::Values(std::tuple{Index{500}, 0.5}, std::tuple{Index{500}, 12.0}));

TEST(RotatingFrame, MassesOfAnyConditionKeepTheBound) {
  for (const double condition : {10.0, 1e3, 1e6}) {
    for (const Index half : {3, 20, 100}) {
      for (const double spin : {0.0, 0.5, 3.25123, 7.0517, 10.5, 40.0}) {
        const Family f = family(half, spin, 5, {false, condition});
        const ModesResult r = with_shapes(f);
        SCOPED_TRACE("condition " + std::to_string(condition) + ", half " + std::to_string(half) + ", spin " + std::to_string(spin));
        expect_truth(f, r);
        expect_signs(f, r);
        EXPECT_EQ(r.stability, spin < f.omega(0) ? Stability::stable : Stability::gyroscopically_stabilised);
      }
    }
  }
}

TEST(RotatingFrame, ZeroModeWhereTheSpinMeetsAFrequency) {
  for (const Index half : {3, 20, 100}) {
    for (const double condition : {1.0, 1e3}) {
      const Family f = family(half, 0, 11, {true, condition});
      const ModesResult r = with_shapes(f);
      EXPECT_EQ(r.index_balance.zero, 1);
      EXPECT_EQ(r.modes[0].omega, 0);
      expect_truth(f, r);
      EXPECT_EQ(r.stability, half / 3 == 0 ? Stability::stable : Stability::marginal);
    }
  }
}

// The full size takes half a minute: asked for with GYROMODE_RANDOM_SYSTEMS of 100000 or more (./check --full).
TEST(RotatingFrame, TwoThousandCoordinates) {
  const char* asked = std::getenv("GYROMODE_RANDOM_SYSTEMS");
  if (!asked || std::atol(asked) < 100000) GTEST_SKIP() << "only with ./check --full";
  for (const double spin : {0.0, 0.5, 5.4321, 12.0}) {
    for (const double condition : {1.0, 1e3}) {
      const Family f = family(1000, spin, 3, {false, condition});
      const ModesResult r = with_shapes(f);
      expect_truth(f, r);
      expect_signs(f, r);
    }
  }
}

}  // namespace
}  // namespace gyromode
