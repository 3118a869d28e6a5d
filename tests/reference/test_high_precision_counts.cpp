// The high-precision twin against the counting theorems (T9), (T10), (T12), trace and determinant on random systems;
// and what it refuses.

#include "spectrum_checks.h"

#include "gyromode/base/error.h"
#include "gyromode/lapack/small.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace gyromode::reference {

namespace {

using enum Spectrum::Verdict;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const MatrixXd J = (MatrixXd(2, 2) << 0, -1, 1, 0).finished();

// ---- random systems

struct RandomSystem {
  MatrixXd M, G, K;

  RandomSystem(Index n, double gyroscopic, std::mt19937_64& engine) {
    std::normal_distribution<double> normal;
    const auto random = [&] { return MatrixXd(MatrixXd::NullaryExpr(n, n, [&] { return normal(engine); })); };
    const MatrixXd a = random(), b = random(), c = random();
    M = 5 * static_cast<double>(n) * MatrixXd::Identity(n, n) + a + a.transpose();
    G = gyroscopic * (b - b.transpose());
    K = c + c.transpose();
  }
};

int negatives(const Spectrum& s) { return static_cast<int>(std::count(s.energy_sign.begin(), s.energy_sign.end(), -1)); }

TEST(HighPrecision, IndexBalanceOnRandomSystems) {
  std::mt19937_64 engine(1979);
  int stabilised = 0, diverging = 0, fluttering = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Index n = 1 + trial % 6;
    const RandomSystem r(n, trial % 2 == 0 ? 3 : 30, engine);
    const Spectrum s = spectrum(r.M, r.G, r.K);
    SCOPED_TRACE("trial " + std::to_string(trial));
    expect_complete(s, n);
    EXPECT_EQ(s.zero_roots, 0);
    EXPECT_EQ(s.negative_stiffness,  // (T12), K nonsingular
              static_cast<int>(s.divergence.size() + 2 * s.flutter.size()) + 2 * negatives(s));
    stabilised += s.verdict == gyroscopically_stabilised;
    diverging += !s.divergence.empty();
    fluttering += !s.flutter.empty();
  }
  EXPECT_GT(stabilised, 5);
  EXPECT_GT(diverging, 20);
  EXPECT_GT(fluttering, 20);
}

TEST(HighPrecision, SignedCountOnRandomSystems) {  // (T9)
  std::mt19937_64 engine(9);
  std::uniform_real_distribution<double> window(0.01, 1.5);
  for (int trial = 0; trial < 60; ++trial) {
    const RandomSystem r(1 + trial % 6, 10, engine);
    const Spectrum s = spectrum(r.M, r.G, r.K);
    const double sigma = window(engine);
    int signed_count = 0;
    for (std::size_t i = 0; i < s.omega.size(); ++i) signed_count += s.omega[i] < sigma ? s.energy_sign[i] : 0;
    EXPECT_EQ(negative_eigenvalues_of_impedance(r.M, r.G, r.K, sigma) - s.negative_stiffness, signed_count);
    EXPECT_EQ(negative_eigenvalues_of_impedance(r.M, r.G, r.K, -sigma), negative_eigenvalues_of_impedance(r.M, r.G, r.K, sigma));
    EXPECT_EQ(negative_eigenvalues_of_impedance(r.M, r.G, r.K, 0), s.negative_stiffness);
  }
}

TEST(HighPrecision, TraceAndDeterminantOnRandomSystems) {
  // Σλ² = −2 tr M⁻¹K + tr (M⁻¹G)²,  Πλ = det K / det M
  std::mt19937_64 engine(10);
  for (int trial = 0; trial < 40; ++trial) {
    const RandomSystem r(1 + trial % 8, 10, engine);
    const Spectrum s = spectrum(r.M, r.G, r.K);
    double sum = 0, product = 1;
    for (const double w : s.omega) sum -= 2 * w * w, product *= w * w;
    for (const double d : s.divergence) sum += 2 * d * d, product *= -d * d;
    for (const auto& [d, w] : s.flutter) sum += 4 * (d * d - w * w), product *= std::pow(d * d + w * w, 2);
    const MatrixXd k = small::solve(r.M, r.K), g = small::solve(r.M, r.G);
    EXPECT_NEAR(sum, (g * g - 2 * k).trace(), 1e-12 * (g.squaredNorm() + k.norm()));
    EXPECT_NEAR(product, k.determinant(), 1e-11 * std::abs(product));
  }
}

/// F of (T10): M + GᵀK⁺G on null K ∩ null NᵀGN, in double, for matrices of small integers.
struct NullSpaceForms {
  Index r = 0, s = 0, negative = 0;
  bool nonsingular = true;

  NullSpaceForms(const MatrixXd& M, const MatrixXd& G, const MatrixXd& K) {
    const MatrixXd N = null_space(K);
    r = N.cols();
    if (r == 0) return;
    const MatrixXd inner = N * null_space(N.transpose() * G * N);
    s = (r - inner.cols()) / 2;
    if (inner.cols() == 0) return;
    const MatrixXd pseudo = K.completeOrthogonalDecomposition().pseudoInverse();
    const VectorXd f = small::symmetric_eigenvalues(inner.transpose() * (M + G.transpose() * pseudo * G) * inner);
    negative = (f.array() < 0).count();
    nonsingular = f.cwiseAbs().minCoeff() > 1e-9;
  }

  static MatrixXd null_space(const MatrixXd& A) {
    const small::Svd svd = small::singular_value_decomposition(A.cast<std::complex<double>>());
    const Index rank = (svd.values.array() > 1e-9).count();
    return svd.v.real().rightCols(A.cols() - rank);
  }
};

TEST(HighPrecision, IndexBalanceWithSingularStiffness) {
  std::mt19937_64 engine(1010);
  std::uniform_int_distribution<int> entry(-3, 3), rank(0, 4);
  int tested = 0, with_negative_F = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Index n = 2 + trial % 5;
    const auto random = [&](Index rows) { return MatrixXd(MatrixXd::NullaryExpr(rows, n, [&] { return double(entry(engine)); })); };
    const MatrixXd a = random(n), b = random(n), c = random(std::min<Index>(rank(engine), n - 1));
    const MatrixXd M = a.transpose() * a / 64 + MatrixXd::Identity(n, n), G = b - b.transpose();
    const VectorXd signs = VectorXd::NullaryExpr(c.rows(), [&] { return entry(engine) < 0 ? -1.0 : 1.0; });
    const MatrixXd K = c.transpose() * signs.asDiagonal() * c;
    const NullSpaceForms forms(M, G, K);
    if (!forms.nonsingular) continue;
    SCOPED_TRACE("trial " + std::to_string(trial));
    const Spectrum s = spectrum(M, G, K);
    expect_complete(s, n);
    EXPECT_EQ(s.zero_stiffness, forms.r);
    EXPECT_EQ(s.zero_roots, 2 * (forms.r - forms.s));
    if (std::count(s.energy_sign.begin(), s.energy_sign.end(), 0) > 0) continue;  // defective: (T12) does not apply
    EXPECT_EQ(s.negative_stiffness, static_cast<int>(s.divergence.size() + 2 * s.flutter.size()) + 2 * negatives(s) + forms.negative);
    ++tested;
    with_negative_F += forms.negative > 0;
  }
  EXPECT_GT(tested, 100);
  EXPECT_GT(with_negative_F, 5);
}

// ---- broken promises

void expect_refusal(const MatrixXd& M, const MatrixXd& G, const MatrixXd& K, const std::string& reason) {
  try {
    spectrum(M, G, K);
    FAIL() << "accepted, though: " << reason;
  } catch (const InvalidArgument& refusal) {
    EXPECT_NE(std::string(refusal.what()).find(reason), std::string::npos) << refusal.what();
  }
}

TEST(HighPrecision, RefusesBrokenPromises) {
  const MatrixXd one = MatrixXd::Identity(2, 2);
  expect_refusal(one, J, MatrixXd::Identity(3, 3), "one size");
  expect_refusal(one + J, J, one, "M = Mᵀ");
  expect_refusal(one, one, one, "G = −Gᵀ");
  expect_refusal(one, J, one + J, "K = Kᵀ");
  expect_refusal(-one, J, one, "positive definite");
  expect_refusal(one, J, one * std::nan(""), "finite");
}

}  // namespace
}  // namespace gyromode::reference
