// Published and closed-form cases: values, verdicts, signs, at the numbers their sources print.
#include "analytic/closed_forms.h"

#include "gyromode/modes/modes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gyromode {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rpm = pi / 30;

std::vector<double> frequencies(const ModesResult& r) {
  std::vector<double> all;
  for (const Mode& m : r.modes) all.push_back(m.omega);
  return all;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected, double relative) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], relative * expected[i]) << "mode " << i;
}

const std::vector<Method> classical_too{Method::automatic, Method::general, Method::companion};

class EveryMethod : public testing::TestWithParam<Method> {
 protected:
  ModesResult solve(const System& s) const {
    ModesOptions options;
    options.method = GetParam();
    return find_modes(s, options);
  }
};
INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod, testing::ValuesIn(classical_too));

// ANSYS VM197 case 1 = Friswell et al. 2010, pp. 423–429; both thresholds √(Kx/m), √(Ky/m) in rpm.
TEST_P(EveryMethod, SpringMassInTurningAxes) {
  const auto at = [&](double speed) { return solve(analytic::SpringMass{0.2, 40e3, 200e3, 50e3, speed * rpm}.system()); };
  expect_near(frequencies(at(0)), {71.1762543417 * 2 * pi, 500, 1000}, 1e-11);
  expect_near(frequencies(at(500)), {70.2087544037 * 2 * pi, 500, 160.0186701190 * 2 * pi}, 1e-11);
  expect_near(frequencies(at(1000)), {67.3959537947 * 2 * pi, 500, 162.5106029167 * 2 * pi}, 1e-11);
  const ModesResult divergent = at(8000);
  expect_near(frequencies(divergent), {500, 259.5704423449 * 2 * pi}, 1e-11);
  ASSERT_EQ(divergent.unstable.size(), 1u);
  EXPECT_NEAR(divergent.unstable[0].growth_rate, 37.7478991587 * 2 * pi, 1e-10 * 237);
  EXPECT_FALSE(divergent.unstable[0].flutter());
  EXPECT_EQ(divergent.stability, Stability::unstable);
  const ModesResult stabilised = at(12000);
  expect_near(frequencies(stabilised), {69.6826260417 * 2 * pi, 500, 324.8702613670 * 2 * pi}, 1e-11);
  EXPECT_EQ(stabilised.stability, Stability::gyroscopically_stabilised);
  EXPECT_EQ(stabilised.modes[0].energy_sign, -1);
  EXPECT_EQ(at(1000).stability, Stability::stable);
}

TEST_P(EveryMethod, UnequalTransverseStiffness) {
  const auto at = [&](double spin) { return solve(analytic::SpringMass{1, 1, 2.25, 1e4, spin}.system()); };
  expect_near(frequencies(at(0.5)), {0.6747391448, 1.8151383106, 100}, 1e-10);
  const ModesResult between = at(1.25);
  EXPECT_EQ(between.stability, Stability::unstable);
  ASSERT_EQ(between.unstable.size(), 1u);
  EXPECT_NEAR(between.unstable[0].growth_rate, 0.2451433544, 1e-10);
  expect_near(frequencies(between), {2.5367489557, 100}, 1e-10);
  expect_near(frequencies(at(2)), {0.6984406582, 3.2805762675, 100}, 1e-10);
  EXPECT_EQ(at(2).stability, Stability::gyroscopically_stabilised);
}

TEST_P(EveryMethod, StabilisationThreshold) {
  const auto at = [&](double g) { return solve(analytic::StabilisedPair{1, 4, g}.system()); };
  EXPECT_EQ(at(3).stability, Stability::marginal);
  for (const double g : {3 + 1e-6, 3.1, 4.0, 100.0}) {
    const ModesResult r = at(g);
    EXPECT_EQ(r.stability, Stability::gyroscopically_stabilised) << g;
    expect_near(frequencies(r), analytic::StabilisedPair{1, 4, g}.frequencies(), 1e-10);
    EXPECT_EQ(r.modes[0].energy_sign, -1);
    EXPECT_EQ(r.modes[1].energy_sign, 1);
  }
  const ModesResult flutter = at(2.9);
  EXPECT_EQ(flutter.stability, Stability::unstable);
  ASSERT_EQ(flutter.unstable.size(), 1u);
  EXPECT_NEAR(flutter.unstable[0].growth_rate, 0.3840572874, 1e-10);
  EXPECT_NEAR(flutter.unstable[0].omega, 1.3610657589, 1e-10);
  const ModesResult just_below = at(3 - 1e-6);
  EXPECT_EQ(just_below.stability, Stability::unstable);
  ASSERT_EQ(just_below.unstable.size(), 1u);
  // λ² = −[b ± √(b² − 16)]/2, b = g² − 5: |λ|² = 2, 2 Re(λ²) = −b
  const double g = 3 - 1e-6;
  const Complex lambda = std::sqrt(Complex(-0.5 * (g * g - 5), 0.5 * std::sqrt(16 - (g * g - 5) * (g * g - 5))));
  EXPECT_NEAR(just_below.unstable[0].growth_rate, lambda.real(), 1e-10);
  EXPECT_NEAR(just_below.unstable[0].omega, lambda.imag(), 1e-10);
}

TEST_P(EveryMethod, SpinningRigidBody) {
  const double spin = 10 * rpm;
  for (const auto& [i1, i2, i3, verdict] :
       {std::tuple{90.0, 110.0, 150.0, Stability::stable}, std::tuple{90.0, 150.0, 110.0, Stability::unstable},
        std::tuple{110.0, 150.0, 90.0, Stability::gyroscopically_stabilised}}) {
    const analytic::SpinningBody body{i1, i2, i3, spin};
    const ModesResult r = solve(body.system());
    EXPECT_EQ(r.stability, verdict);
    EXPECT_NEAR(r.modes.back().omega, spin, 1e-14 * spin);
    const double squared = body.nutation_squared();
    if (squared < 0) {
      ASSERT_EQ(r.unstable.size(), 1u);
      EXPECT_NEAR(r.unstable[0].growth_rate, std::sqrt(-squared), 1e-14);
    } else {
      EXPECT_NEAR(r.modes.front().omega, std::sqrt(squared), 1e-14);
    }
  }
}

TEST(SpinningRigidBody, MovesInQuadrature) {
  const ModesResult r = find_modes(analytic::SpinningBody{90, 110, 150, 1}.system());
  EXPECT_EQ(r.structure.in_phase(), std::vector<Index>{0});
  EXPECT_EQ(r.structure.in_quadrature(), std::vector<Index>{1});
}

TEST(Meirovitch, FrequenciesAreRootsOfTheCubic) {
  const ModesResult r = find_modes(analytic::MeirovitchBody{3, 4.2, 0.8, 1.5, 5, 1.1}.system());
  expect_near(frequencies(r), {0.189680465035159, 2.48169419315294, 4.05201372811779}, 4e-15);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
  ModesOptions whole;
  whole.method = Method::general;
  expect_near(frequencies(find_modes(analytic::MeirovitchBody{3, 4.2, 0.8, 1.5, 5, 1.1}.system(), whole)), frequencies(r), 1e-14);
}

TEST(Wiresaw, TruncatedAndContinuum) {
  const ModesResult r = find_modes(analytic::wiresaw(10, 0.01));
  EXPECT_NEAR(r.modes[0].omega / pi, 0.999900040534, 1e-12);
  EXPECT_NEAR(r.modes[9].omega, 31.426809594215, 1e-11);
  EXPECT_NEAR(r.modes[8].omega, 28.272138604729, 1e-11);
  // v = 0.5: ω₁/π → 1 − v² as n⁻³
  double previous = 0;
  for (const auto& [n, expected] :
       {std::pair{10, .750090649561}, std::pair{20, .750011887547}, std::pair{40, .750001530029}, std::pair{160, .750000024512}}) {
    const double found = find_modes(analytic::wiresaw(n, 0.5)).modes[0].omega / pi;
    EXPECT_NEAR(found, expected, 1e-12);
    if (n == 20) {
      EXPECT_NEAR((previous - 0.75) / (found - 0.75), 8, 0.5);
    }
    previous = found;
  }
}

TEST(Wiresaw, TruncationFluttersBeyondTheWaveSpeed) {
  const ModesResult r = find_modes(analytic::wiresaw(10, 1.5));
  EXPECT_EQ(r.stability, Stability::unstable);
  ASSERT_GE(r.unstable.size(), 2u);
  EXPECT_NEAR(r.unstable[0].growth_rate, 9.908271, 1e-6);
  EXPECT_NEAR(r.unstable[0].omega, 4.464646, 1e-6);
  EXPECT_NEAR(r.unstable[1].growth_rate, 5.675294, 1e-6);
  EXPECT_NEAR(r.unstable[1].omega, 13.946173, 1e-6);
}

// Simply supported pipe conveying fluid by N sine functions: near the exact roots of the continuum.
TEST(FluidConveyingPipe, ApproachesTheContinuum) {
  const Index n = 80;
  const double u = 2, beta = 0.5;
  Matrix k = Matrix::Zero(n, n);
  Matrix g = Matrix::Zero(n, n);
  for (Index i = 0; i < n; ++i) {
    const double j = static_cast<double>(i + 1);
    k(i, i) = std::pow(j * pi, 4) - u * u * j * j * pi * pi;
    for (Index l = 0; l < n; ++l) {
      const double m = static_cast<double>(l + 1);
      if ((i + l) % 2 == 1) g(i, l) = 2 * std::sqrt(beta) * u * 4 * j * m / (j * j - m * m);
    }
  }
  const ModesResult r = find_modes(System(Matrix::Identity(n, n), g, k));
  const double exact[] = {7.453573112132, 37.632134215692, 87.104397136948, 156.249650558925};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(r.modes[i].omega, exact[i], 1e-7 * exact[i]);
}

}  // namespace
}  // namespace gyromode
