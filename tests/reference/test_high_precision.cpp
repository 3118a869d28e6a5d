// The high-precision twin against closed forms: published.md (A1, A11, B1–B4), rigid bodies, defective roots made of
// integers.

#include "spectrum_checks.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <ostream>
#include <random>
#include <string>
#include <vector>

namespace gyromode::reference {

namespace {

using enum Spectrum::Verdict;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Signs = std::vector<int>;
using Values = std::vector<double>;
using std::numbers::pi;

const MatrixXd J = (MatrixXd(2, 2) << 0, -1, 1, 0).finished();

MatrixXd diagonal(const Values& d) { return Eigen::Map<const VectorXd>(d.data(), static_cast<Index>(d.size())).asDiagonal(); }

MatrixXd kron(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd c(a.rows() * b.rows(), a.cols() * b.cols());
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j) c.block(i * b.rows(), j * b.cols(), b.rows(), b.cols()) = a(i, j) * b;
  return c;
}

Values sorted(Values v) {
  std::sort(v.begin(), v.end());
  return v;
}

/// Equal to a few units in the last place of the expected formula.
void expect_values(const Values& found, const Values& expected, double relative = 4e-15) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], relative * std::abs(expected[i])) << "value " << i;
}

Values in_hertz(Values omega) {
  for (double& w : omega) w /= 2 * pi;
  return omega;
}

// ---- B1: rotating frame, spectrum { |ω_k − Ω|, ω_k + Ω }

/// ω_k = 1, 2, 3 in coordinates changed by an integer S, so that every entry is exact.
struct RotatingFrame {
  double spin;
  MatrixXd S = (MatrixXd(3, 3) << 1, 2, 0, 0, 1, 1, 1, 0, 1).finished();
  MatrixXd M0 = S.transpose() * S, K0 = S.transpose() * diagonal({1, 4, 9}) * S, one = MatrixXd::Identity(2, 2);

  Spectrum solve() const { return spectrum(kron(one, M0), kron(2 * spin * J, M0), kron(one, K0 - spin * spin * M0)); }
};

TEST(HighPrecision, B1StabilisedByRotation) {
  const Spectrum s = RotatingFrame{1.25}.solve();
  expect_values(s.omega, {0.25, 0.75, 1.75, 2.25, 3.25, 4.25}, 1e-16);
  EXPECT_EQ(s.energy_sign, (Signs{-1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(s.verdict, gyroscopically_stabilised);
  EXPECT_EQ(s.negative_stiffness, 2);
  EXPECT_LE(s.distance, 0.5 / 4.25 * (1 + 1e-15));
  expect_complete(s, 6);
}

TEST(HighPrecision, B1NegativeDefiniteStiffness) {
  const Spectrum s = RotatingFrame{4}.solve();
  expect_values(s.omega, {1, 2, 3, 5, 6, 7}, 1e-16);
  EXPECT_EQ(s.energy_sign, (Signs{-1, -1, -1, 1, 1, 1}));
  EXPECT_EQ(s.verdict, gyroscopically_stabilised);
  EXPECT_EQ(s.negative_stiffness, 6);
}

TEST(HighPrecision, B1OppositeSignsCoincideSemisimply) {
  const Spectrum s = RotatingFrame{1.5}.solve();  // 1.5 − 1 with sign −, 2 − 1.5 with sign +
  expect_values(s.omega, {0.5, 0.5, 1.5, 2.5, 3.5, 4.5}, 1e-16);
  EXPECT_EQ(s.energy_sign, (Signs{1, -1, 1, 1, 1, 1}));
  EXPECT_EQ(s.verdict, marginal);
  EXPECT_EQ(s.distance, 0);
}

TEST(HighPrecision, B1EqualSignsCoincideHarmlessly) {
  const Spectrum s = RotatingFrame{0.5}.solve();  // 1 + ½ = 2 − ½, 2 + ½ = 3 − ½, K > 0
  expect_values(s.omega, {0.5, 1.5, 1.5, 2.5, 2.5, 3.5}, 1e-16);
  EXPECT_EQ(s.energy_sign, (Signs{1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(s.verdict, stable);
  EXPECT_GT(s.distance, 1e-3);
}

TEST(HighPrecision, B1CriticalSpeedHasSemisimpleZero) {
  const Spectrum s = RotatingFrame{2}.solve();
  EXPECT_EQ(s.zero_roots, 2);
  EXPECT_EQ(s.zero_stiffness, 2);
  expect_values(s.omega, {1, 1, 3, 4, 5}, 1e-16);
  EXPECT_EQ(s.energy_sign, (Signs{1, -1, 1, 1, 1}));
  EXPECT_EQ(s.verdict, marginal);
  const Spectrum lowest = RotatingFrame{1}.solve();  // K ≥ 0
  EXPECT_EQ(lowest.zero_roots, 2);
  EXPECT_EQ(lowest.verdict, stable);
}

// ---- B2: unequal transverse stiffness

Spectrum unequal_shaft(double spin) {
  return spectrum(MatrixXd::Identity(2, 2), 2 * spin * J, diagonal({1 - spin * spin, 2.25 - spin * spin}));
}

TEST(HighPrecision, B2UnequalShaft) {
  const Spectrum slow = unequal_shaft(0.5), between = unequal_shaft(1.25), fast = unequal_shaft(2);
  expect_values(slow.omega, {0.6747391448, 1.8151383106}, 1e-10);
  EXPECT_EQ(slow.verdict, stable);
  EXPECT_NEAR(slow.distance, 0.75 / 2, 1e-15);
  expect_values(between.omega, {2.5367489557}, 1e-10);
  expect_values(between.divergence, {0.2451433544}, 1e-9);
  EXPECT_EQ(between.verdict, unstable);
  EXPECT_EQ(between.negative_stiffness, 1);
  EXPECT_NEAR(between.distance, 0.2451433544 / 2.5367489557, 1e-10);
  expect_values(fast.omega, {0.6984406582, 3.2805762675}, 1e-10);
  EXPECT_EQ(fast.energy_sign, (Signs{-1, 1}));
  EXPECT_EQ(fast.verdict, gyroscopically_stabilised);
}

// ---- B3: stabilisation threshold, K = −diag(1, 4), G = gJ
// --------------------------------------------------------------------- ω = (√(g² − 1) ± √(g² − 9))/2 for g > 3, λ =
// ±√(9 − g²)/2 ± j√(g² − 1)/2 for 1 < g < 3

Spectrum top(double g) { return spectrum(MatrixXd::Identity(2, 2), g * J, diagonal({-1, -4})); }

TEST(HighPrecision, B3AboveThreshold) {
  for (const double g : {3 + 1e-6, 3.1, 4.0}) {
    const Spectrum s = top(g);
    const double sum = std::sqrt((g - 1) * (g + 1)), difference = std::sqrt((g - 3) * (g + 3));
    expect_values(s.omega, {(sum - difference) / 2, (sum + difference) / 2});
    EXPECT_EQ(s.energy_sign, (Signs{-1, 1}));
    EXPECT_EQ(s.verdict, gyroscopically_stabilised);
    EXPECT_NEAR(s.distance, std::min(0.25, 2 * difference / (sum + difference)), 1e-14);
  }
  expect_values(top(4).omega, {0.6136160176, 3.2593673286}, 1e-10);
}

TEST(HighPrecision, B3BelowThreshold) {
  for (const double g : {3 - 1e-6, 2.9}) {
    const Spectrum s = top(g);
    ASSERT_EQ(s.flutter.size(), 1U);
    const double sigma = std::sqrt((3 - g) * (3 + g)) / 2, omega = std::sqrt((g - 1) * (g + 1)) / 2;
    expect_values({s.flutter[0].first, s.flutter[0].second}, {sigma, omega});
    EXPECT_EQ(s.verdict, unstable);
    EXPECT_NEAR(s.distance, std::min(0.25, sigma / std::sqrt(2.0)), 1e-14);  // |λ|² = √(k₁k₂) = 2
    expect_complete(s, 2);
  }
}

TEST(HighPrecision, B3AtThresholdInAnyUnits) {
  for (const double mass : {0x1p-30, 1.0, 0x1p30})
    for (const double time : {0x1p-20, 1.0, 0x1p20}) {
      const Spectrum s = spectrum(mass * MatrixXd::Identity(2, 2), 3 * mass / time * J, mass / (time * time) * diagonal({-1, -4}));
      expect_values(s.omega, {std::sqrt(2) / time, std::sqrt(2) / time}, 3e-16);
      EXPECT_EQ(s.energy_sign, (Signs{0, 0}));
      EXPECT_EQ(s.verdict, marginal);
      EXPECT_EQ(s.distance, 0);
    }
}

TEST(HighPrecision, B3OneRoundingFromThresholdIsDecided) {
  const double above = std::nextafter(3.0, 4.0), below = std::nextafter(3.0, 2.0);
  EXPECT_EQ(top(above).verdict, gyroscopically_stabilised);
  EXPECT_EQ(top(below).verdict, unstable);
  EXPECT_NEAR(top(below).distance, std::sqrt(6 * 0x1p-51) / 2 / std::sqrt(2.0), 1e-9);
}

TEST(HighPrecision, B3TwoThresholdsAndAnOscillator) {
  // Two Jordan blocks of size 2 at ω = √2; and K₃ = 2 puts a semisimple root of sign + beside a third.
  const Spectrum two = spectrum(MatrixXd::Identity(4, 4), kron(MatrixXd::Identity(2, 2), 3 * J), diagonal({-1, -4, -1, -4}));
  expect_values(two.omega, Values(4, std::sqrt(2)), 3e-16);
  EXPECT_EQ(two.energy_sign, (Signs{0, 0, 0, 0}));
  MatrixXd G = MatrixXd::Zero(3, 3);
  G.topLeftCorner(2, 2) = 3 * J;
  const Spectrum mixed = spectrum(MatrixXd::Identity(3, 3), G, diagonal({-1, -4, 2}));
  expect_values(mixed.omega, Values(3, std::sqrt(2)), 3e-16);
  EXPECT_EQ(mixed.energy_sign, (Signs{1, 0, 0}));
  EXPECT_EQ(mixed.verdict, marginal);
}

// ---- B4: free rigid body, ω = Ω and Ω√((C−A)(C−B)/(AB))

Spectrum rigid_body(double A, double B, double C, double spin = 1) {
  return spectrum(diagonal({A, B}), (A + B - C) * spin * J, diagonal({spin * spin * (C - B), spin * spin * (C - A)}));
}

TEST(HighPrecision, B4MajorAxis) {
  const Spectrum s = rigid_body(90, 110, 150);
  expect_values(s.omega, {std::sqrt(40.0 * 60 / 9900), 1});
  EXPECT_EQ(s.verdict, stable);
  expect_values(rigid_body(90, 110, 150, pi / 3).omega, {0.5156044317, 1.0471975512}, 1e-10);
}

TEST(HighPrecision, B4IntermediateAndMinorAxis) {
  const Spectrum intermediate = rigid_body(90, 110, 100), minor = rigid_body(90, 110, 50);
  expect_values(intermediate.omega, {1});
  expect_values(intermediate.divergence, {std::sqrt(100.0 / 9900)});
  EXPECT_EQ(intermediate.verdict, unstable);
  expect_values(minor.omega, {std::sqrt(2400.0 / 9900), 1});
  EXPECT_EQ(minor.energy_sign, (Signs{-1, 1}));
  EXPECT_EQ(minor.verdict, gyroscopically_stabilised);
}

TEST(HighPrecision, B4Lamina) {  // C = A + B: G = 0, K = M
  const Spectrum s = rigid_body(90, 110, 200);
  expect_values(s.omega, {1, 1}, 1e-16);
  EXPECT_EQ(s.energy_sign, (Signs{1, 1}));
  EXPECT_EQ(s.verdict, stable);
}

TEST(HighPrecision, B4AxisymmetricMajorAndDegenerate) {
  const Spectrum sphere = rigid_body(100, 100, 100);  // K = 0: precession at ω = 1, and a tilt that stays where it is put
  EXPECT_EQ(sphere.zero_roots, 2);
  expect_values(sphere.omega, {1}, 1e-16);
  EXPECT_EQ(sphere.verdict, stable);
  EXPECT_EQ(sphere.distance, 1);
}

// ---- A1: rotating mass on springs

Spectrum rotating_mass(double rpm) {
  const double m = 0.2, spin = rpm * 2 * pi / 60, softening = m * spin * spin;
  MatrixXd G = MatrixXd::Zero(3, 3);
  G.topLeftCorner(2, 2) = 2 * m * spin * J;
  return spectrum(m * MatrixXd::Identity(3, 3), G, diagonal({40e3 - softening, 200e3 - softening, 50e3}));
}

TEST(HighPrecision, A1RotatingMass) {
  const double axial = 79.5774715459;
  const Spectrum rest = rotating_mass(0), slow = rotating_mass(1000), fast = rotating_mass(8000), faster = rotating_mass(12000);
  expect_values(in_hertz(rest.omega), {71.1762543417, axial, 159.1549430919}, 1e-12);
  expect_values(in_hertz(rotating_mass(500).omega), {70.2087544037, axial, 160.0186701190}, 1e-12);
  expect_values(in_hertz(slow.omega), {67.3959537947, axial, 162.5106029167}, 1e-12);
  EXPECT_EQ(slow.verdict, stable);
  expect_values(in_hertz(fast.omega), {axial, 259.5704423449}, 1e-12);
  expect_values(in_hertz(fast.divergence), {37.7478991587}, 1e-11);
  EXPECT_EQ(fast.verdict, unstable);
  expect_values(in_hertz(faster.omega), {69.6826260417, axial, 324.8702613670}, 1e-12);
  EXPECT_EQ(faster.energy_sign, (Signs{-1, 1, 1}));
  EXPECT_EQ(faster.verdict, gyroscopically_stabilised);
}

TEST(HighPrecision, A1BothThresholds) {
  EXPECT_EQ(rotating_mass(4270.57).verdict, stable);
  EXPECT_EQ(rotating_mass(4270.58).verdict, unstable);
  EXPECT_EQ(rotating_mass(9549.29).verdict, unstable);
  EXPECT_EQ(rotating_mass(9549.30).verdict, gyroscopically_stabilised);
  EXPECT_LT(rotating_mass(4270.58).distance, 1e-5);
}

// ---- A11: wiresaw

struct Wiresaw {
  MatrixXd M, G, K;

  Wiresaw(int n, double v) : M(MatrixXd::Identity(n, n) / 2), G(MatrixXd::Zero(n, n)), K(MatrixXd::Zero(n, n)) {
    for (int j = 1; j <= n; ++j) {
      K(j - 1, j - 1) = j * j * pi * pi * (1 - v * v) / 2;
      for (int k = j + 1; k <= n; k += 2) G(j - 1, k - 1) = 4.0 * j * k * v / (j * j - k * k);
    }
    G -= MatrixXd(G.transpose());
  }
  Spectrum solve() const { return spectrum(M, G, K); }
};

TEST(HighPrecision, A11PublishedAtTen) {
  const Spectrum s = Wiresaw(10, 0.01).solve();
  ASSERT_EQ(s.omega.size(), 10U);
  expect_values({s.omega[0] / pi, s.omega[1] / pi, s.omega[2] / pi}, {0.999900040534, 1.999800455140, 2.999701236609}, 1e-12);
  expect_values({s.omega[8], s.omega[9]}, {28.272138604729, 31.426809594215}, 1e-13);
  EXPECT_NEAR(Wiresaw(10, 0.5).solve().omega[0] / pi, 0.750090649561, 1e-12);
}

TEST(HighPrecision, A11InvariantsAtSix) {
  for (const double v : {0.01, 0.5, 0.9}) {
    const Wiresaw w(6, v);
    const Spectrum s = w.solve();
    ASSERT_EQ(s.omega.size(), 6U);
    double sum = 0, product = 1;
    for (const double omega : s.omega) sum += omega * omega, product *= omega * omega;
    EXPECT_NEAR(sum, 2 * w.K.trace() + 2 * w.G.squaredNorm(), 1e-13 * sum);  // Σω² = tr k + ½‖g‖², M = ½
    EXPECT_NEAR(product, (2 * w.K).determinant(), 1e-13 * product);
    EXPECT_EQ(s.energy_sign, Signs(6, 1));
    EXPECT_EQ(s.verdict, stable);
    EXPECT_NEAR(s.distance, 1.0 / 36, 1e-15);
  }
}

TEST(HighPrecision, A11SpuriousFlutterAboveTheCriticalSpeed) {
  const Spectrum s = Wiresaw(10, 1.5).solve();
  const auto near = [&](double sigma, double omega) {
    return std::any_of(s.flutter.begin(), s.flutter.end(),
                       [&](const auto& f) { return std::abs(f.first - sigma) < 1e-6 && std::abs(f.second - omega) < 1e-6; });
  };
  EXPECT_TRUE(near(5.675294, 13.946173));
  EXPECT_TRUE(near(9.908271, 4.464646));
  EXPECT_EQ(s.verdict, unstable);
  expect_complete(s, 10);
}

// ---- K singular: rigid modes and the root 0

/// Laplacian of a free-free chain of unit springs, eigenvalues 4 sin²(jπ/2n), j = 0 … n−1.
MatrixXd chain(Index n) {
  MatrixXd L = 2 * MatrixXd::Identity(n, n);
  L.diagonal(1).setConstant(-1);
  L.diagonal(-1).setConstant(-1);
  L(0, 0) = L(n - 1, n - 1) = 1;
  return L;
}

double chain_frequency(Index j, Index n) { return 2 * std::sin(pi * static_cast<double>(j) / static_cast<double>(2 * n)); }

TEST(HighPrecision, FreeChainAtRest) {
  const Spectrum s = spectrum(MatrixXd::Identity(5, 5), MatrixXd::Zero(5, 5), chain(5));
  EXPECT_EQ(s.zero_roots, 2);  // one Jordan block of size 2: uniform translation
  EXPECT_EQ(s.zero_stiffness, 1);
  expect_values(s.omega, {chain_frequency(1, 5), chain_frequency(2, 5), chain_frequency(3, 5), chain_frequency(4, 5)}, 1e-15);
  EXPECT_EQ(s.energy_sign, Signs(4, 1));
  EXPECT_EQ(s.verdict, stable);
  EXPECT_NEAR(s.distance, std::pow(chain_frequency(1, 5) / chain_frequency(4, 5), 2), 1e-15);
}

TEST(HighPrecision, FreeChainInMagneticField) {
  // x and y chains, G = gJ ⊗ 1. Whirl of chain mode κ: ω² ± gω − κ = 0. Translation: ω = g, and a drift 2(r − s) = 2(2
  // − 1).
  const double g = 0.7;
  const MatrixXd one = MatrixXd::Identity(5, 5);
  const Spectrum s = spectrum(MatrixXd::Identity(10, 10), kron(g * J, one), kron(MatrixXd::Identity(2, 2), chain(5)));
  Values expected{g};
  for (Index j = 1; j < 5; ++j) {
    const double root = std::hypot(g / 2, chain_frequency(j, 5));
    expected.insert(expected.end(), {root + g / 2, root - g / 2});
  }
  EXPECT_EQ(s.zero_roots, 2);
  EXPECT_EQ(s.zero_stiffness, 2);
  expect_values(s.omega, sorted(expected));
  EXPECT_EQ(s.energy_sign, Signs(9, 1));
  EXPECT_EQ(s.verdict, stable);
}

TEST(HighPrecision, FreeChainWithOneNegativeSpring) {
  const MatrixXd K = chain(5) - 3 * diagonal({0, 0, 0, 0, 1});
  const Spectrum free = spectrum(MatrixXd::Identity(6, 6), MatrixXd::Zero(6, 6),
                                 (MatrixXd(6, 6) << K, MatrixXd::Zero(5, 1), MatrixXd::Zero(1, 6)).finished());
  EXPECT_EQ(free.zero_roots, 2);
  EXPECT_EQ(free.negative_stiffness, 1);
  EXPECT_EQ(free.verdict, unstable);
  expect_complete(free, 6);
}

TEST(HighPrecision, DefectiveZeroRootOfMultiplicityFour) {
  // K = diag(0, −k), G = gJ: ω² = g² − k and ω² = 0. At g² = k, F of (T10) is singular and all four roots are 0.
  const Spectrum apart = spectrum(MatrixXd::Identity(2, 2), 2 * J, diagonal({0, -3}));
  EXPECT_EQ(apart.zero_roots, 2);
  expect_values(apart.omega, {1}, 1e-16);
  EXPECT_EQ(apart.verdict, marginal);
  const Spectrum four = spectrum(MatrixXd::Identity(2, 2), 2 * J, diagonal({0, -4}));
  EXPECT_EQ(four.zero_roots, 4);
  EXPECT_TRUE(four.omega.empty());
  EXPECT_EQ(four.verdict, marginal);
}

TEST(HighPrecision, NothingButZeros) {
  const Spectrum s = spectrum(MatrixXd::Identity(3, 3), MatrixXd::Zero(3, 3), MatrixXd::Zero(3, 3));
  EXPECT_EQ(s.zero_roots, 6);
  EXPECT_EQ(s.zero_stiffness, 3);
  EXPECT_EQ(s.verdict, stable);
  EXPECT_EQ(spectrum(MatrixXd(0, 0), MatrixXd(0, 0), MatrixXd(0, 0)).verdict, stable);
}

TEST(HighPrecision, JordanBlockOfSizeThree) {
  // det(λ²M + λG + K) = 1350 (λ² + 1)³ with dim null H(1) = 1: an odd block, so n₋(H) jumps by one though its only
  // eigenvector has no energy. (q₁ coupled to two others; partial fractions of (μ + 1)³/((μ − 2)(μ + ½)).)
  MatrixXd G = MatrixXd::Zero(3, 3);
  G(0, 1) = 27, G(1, 0) = -27, G(0, 2) = 1, G(2, 0) = -1;
  const MatrixXd M = diagonal({1, 135, 10}), K = diagonal({-1, -270, 5});
  const Spectrum s = spectrum(M, G, K);
  expect_values(s.omega, {1, 1, 1}, 1e-16);
  EXPECT_EQ(s.energy_sign, (Signs{0, 0, 0}));
  EXPECT_EQ(s.verdict, marginal);
  EXPECT_EQ(negative_eigenvalues_of_impedance(M, G, K, 1.125), 3);
  EXPECT_EQ(negative_eigenvalues_of_impedance(M, G, K, 0.875), 2);
}

TEST(HighPrecision, ProportionalMatricesAtRest) {
  // K = 4M, and K = −M: roots ±2j and ±1, each n-fold. The QR iteration needs its shift here.
  const MatrixXd M = (MatrixXd(2, 2) << 8, -4, -4, 4).finished(), O = MatrixXd::Zero(2, 2);
  expect_values(spectrum(M, O, 4 * M).omega, {2, 2}, 1e-16);
  expect_values(spectrum(M, O, -M).divergence, {1, 1}, 1e-16);
}

TEST(HighPrecision, StiffAndSoftTogether) {
  // Eighteen decades of frequency: every root keeps its own digits.
  MatrixXd G = MatrixXd::Zero(4, 4);
  G.topLeftCorner(2, 2) = 2e9 * J;
  const Spectrum s = spectrum(MatrixXd::Identity(4, 4), G, diagonal({1e-18, 1e-18, 1, 1e18}));
  const double slow = 1e-18 / 2e9, fast = 2e9;
  expect_values(s.omega, {slow, 1, 1e9, fast}, 1e-15);
  EXPECT_EQ(s.zero_roots, 0);
}

}  // namespace
}  // namespace gyromode::reference
