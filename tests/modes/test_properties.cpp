// What must hold between systems that are one system in other words, between methods, and between the modes of one
// system; on 300 random systems. Frequencies are compared within their own error bounds: δω ≤ (residual + ε)·s, with
// the sensitivity s = error_bound/(residual + ε), and a change of the matrices by rounding is a backward error of c n
// ε, which moves ω by c n ε s.
#include "support/random_matrices.h"
#include "support/random_system.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/modes/modes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace gyromode {
namespace {

constexpr std::uint64_t systems = 300;

void for_each_system(const std::function<void(const support::RandomSystem&, std::mt19937_64&)>& check) {
  for (std::uint64_t seed = 0; seed < systems; ++seed) {
    std::mt19937_64 source(seed);
    check(support::random_system(seed), source);
  }
}

ModesResult solved(const System& s, Method method = Method::automatic, bool shapes = false) {
  ModesOptions options;
  options.method = method;
  options.shapes = shapes;
  return find_modes(s, options);
}

// Neither verdict nor first-order error bounds say anything of nearly defective roots.
bool comparable(const ModesResult& r) {
  const bool undecided = std::any_of(r.negative_modes.begin(), r.negative_modes.end(), [](const Mode& m) { return m.energy_sign == 0; });
  return r.stability != Stability::unknown && r.stability != Stability::marginal && r.opposite_gap > 1e-5 && !undecided;
}

double slack(const Mode& m, double backward, Index n) {
  const double sensitivity = m.error_bound / (m.residual + epsilon);
  return m.error_bound + backward * static_cast<double>(n) * epsilon * sensitivity + 4 * epsilon * m.omega;
}

// The same modes, frequencies `factor` times as large, and the same verdict. `backward`: the backward error between the
// two in units of n ε.
void expect_same(const ModesResult& a, const ModesResult& b, const std::string& what, double backward, double factor = 1) {
  ASSERT_EQ(a.modes.size(), b.modes.size()) << what;
  ASSERT_EQ(a.unstable.size(), b.unstable.size()) << what;
  EXPECT_EQ(a.stability, b.stability) << what;
  EXPECT_EQ(a.stiffness.negative, b.stiffness.negative) << what;
  EXPECT_EQ(a.stiffness.zero, b.stiffness.zero) << what;
  std::vector<int> signs_a, signs_b;
  Index n = 2 * static_cast<Index>(a.unstable.size() + a.modes.size());
  for (std::size_t i = 0; i < a.modes.size(); ++i) {
    const double tolerance = factor * slack(a.modes[i], backward, n) + slack(b.modes[i], backward, n);
    EXPECT_LE(std::abs(factor * a.modes[i].omega - b.modes[i].omega), tolerance) << what << ", mode " << i << " at " << b.modes[i].omega;
    signs_a.push_back(a.modes[i].energy_sign);
    signs_b.push_back(b.modes[i].energy_sign);
  }
  EXPECT_EQ(signs_a, signs_b) << what;
}

System changed(const support::RandomSystem& d, double m, double g, double k) {
  return System(m * d.mass, g * d.gyroscopic, k * d.stiffness);
}

TEST(Properties, ReversedSpinHasTheSameFrequencies) {
  Index compared = 0;
  for_each_system([&](const support::RandomSystem& d, std::mt19937_64&) {
    const ModesResult r = solved(d.system());
    if (!comparable(r)) return;
    ++compared;
    expect_same(r, solved(changed(d, 1, -1, 1)), d.description, 4);
  });
  EXPECT_GT(compared, 200);
}

TEST(Properties, PermutedCoordinates) {
  for_each_system([](const support::RandomSystem& d, std::mt19937_64& source) {
    const ModesResult r = solved(d.system());
    if (!comparable(r)) return;
    std::vector<Index> order(static_cast<std::size_t>(d.mass.rows()));
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
    std::shuffle(order.begin(), order.end(), source);
    const System permuted(d.mass(order, order), d.gyroscopic(order, order), d.stiffness(order, order));
    expect_same(r, solved(permuted), d.description, 4);
  });
}

// Powers of four are exact: the same bits, but where K is singular (its null vectors are orthonormalised by LAPACK,
// whose norms rescale).
TEST(Properties, UnitOfMassIsImmaterial) {
  for_each_system([](const support::RandomSystem& d, std::mt19937_64&) {
    const ModesResult r = solved(d.system());
    for (const double unit : {0x1p30, 0x1p-30}) {
      const ModesResult scaled = solved(changed(d, unit, unit, unit));
      ASSERT_EQ(r.modes.size(), scaled.modes.size()) << d.description;
      EXPECT_EQ(r.stability, scaled.stability) << d.description;
      EXPECT_EQ(r.coverage.status, scaled.coverage.status) << d.description;
      if (r.stiffness.zero > 0) {
        if (comparable(r)) expect_same(r, scaled, d.description, 4);
        continue;
      }
      for (std::size_t i = 0; i < r.modes.size(); ++i)
        EXPECT_EQ(r.modes[i].omega, scaled.modes[i].omega) << d.description << ", mode " << i;
      for (std::size_t i = 0; i < r.unstable.size(); ++i)
        EXPECT_EQ(r.unstable[i].growth_rate, scaled.unstable[i].growth_rate) << d.description;
    }
  });
}

// S of entries in quarters, condition below 100: small integers stay exact, so that zero roots do.
TEST(Properties, CongruenceOfCoordinates) {
  Index compared = 0;
  for_each_system([&](const support::RandomSystem& d, std::mt19937_64& source) {
    const ModesResult r = solved(d.system());
    if (!comparable(r)) return;
    const Index n = d.mass.rows();
    Matrix s = Matrix::Identity(n, n);
    std::uniform_int_distribution<int> quarter(-1, 1);
    for (Index j = 0; j < n; ++j) {
      for (Index i = 0; i < n; ++i) s(i, j) += 0.25 * quarter(source);
    }
    const Vector singular = small::symmetric_eigenvalues(s.transpose() * s).cwiseMax(0).cwiseSqrt();
    const double condition = singular(n - 1) / singular(0);
    if (!(condition < 100)) return;
    ++compared;
    const Matrix g = s.transpose() * d.gyroscopic * s;
    const Matrix k = s.transpose() * d.stiffness * s;
    const Matrix m = s.transpose() * d.mass * s;
    expect_same(r, solved(System(symmetric_part(m), skew_part(g), symmetric_part(k))), d.description, 8 * condition * condition);
  });
  EXPECT_GT(compared, 120);
}

TEST(Properties, UnitOfTime) {
  for_each_system([](const support::RandomSystem& d, std::mt19937_64&) {
    const ModesResult r = solved(d.system());
    if (!comparable(r)) return;
    for (const double c : {3.0, 0x1p20, 1e-6})
      expect_same(r, solved(changed(d, 1, c, c * c)), d.description + ", c = " + std::to_string(c), 8, c);
  });
}

// Kelvin, Tait, Chetaev: with any damping D > 0 that is at rest in the axes n₋(K) roots grow, whatever G, K singular or
// not. The roots are those of the companion matrix.
TEST(Properties, DampingMakesAsManyRootsGrowAsKHasNegative) {
  for (std::uint64_t seed = 0; seed < systems; ++seed) {
    support::Source s{std::mt19937_64(seed)};
    const Index n = s.integer(1, 6), negative = s.integer(0, n), zero = s.integer(0, n - negative);
    const Matrix q = s.orthogonal(n);
    Vector d = Vector::Ones(n) * (1 + 0.1 * static_cast<double>(seed % 7));
    for (Index i = 0; i < negative; ++i) d(i) *= -1;
    d.segment(negative, zero).setZero();
    Matrix k = q * d.asDiagonal() * q.transpose();
    k = symmetric_part(k);
    const Matrix m = s.symmetric(n, 0), g = static_cast<double>(s.integer(0, 2)) * s.skew(n), damping = s.symmetric(n, 0);
    Matrix companion = Matrix::Zero(2 * n, 2 * n);
    companion.topRightCorner(n, n).setIdentity();
    companion.bottomLeftCorner(n, n) = -small::inverse(m) * k;
    companion.bottomRightCorner(n, n) = -small::inverse(m) * (g + damping);
    const Eigen::VectorXcd roots = small::eigenvalues(companion);
    const Index growing = (roots.real().array() > 1e-9).count();
    EXPECT_EQ(growing, negative) << seed;
    EXPECT_EQ(find_modes(System(m, g, k)).index_balance.negative, growing) << seed;
  }
}

TEST(Properties, ManyMethodsOneAnswer) {
  Index symmetric = 0;
  for_each_system([&](const support::RandomSystem& d, std::mt19937_64&) {
    const ModesResult r = solved(d.system());
    if (!comparable(r)) return;
    expect_same(r, solved(d.system(), Method::general), d.description + ", general", 8);
    expect_same(r, solved(d.system(), Method::companion), d.description + ", first order", 8);
    // Meirovitch's form squares the condition of diag(M, K): it is compared where that leaves digits.
    const bool graded = d.description.find("graded") != std::string::npos;
    if (r.stiffness.definiteness() != Definiteness::positive || graded) return;
    ++symmetric;
    expect_same(r, solved(d.system(), Method::meirovitch), d.description + ", symmetric 2n", 8);
  });
  EXPECT_GT(symmetric, 60);
}

// Seed 199, graded K > 0: 'symmetric-2n' squares the condition and loses the small frequencies. They cannot be shown to
// exist, and it is not called complete.
TEST(Properties, SymmetricMethodOnGradedStiffness) {
  const support::RandomSystem d = support::random_system(199);
  const ModesResult symmetric = solved(d.system(), Method::meirovitch);
  EXPECT_EQ(symmetric.coverage.status, CoverageStatus::not_counted);
  EXPECT_NE(symmetric.coverage.reason.find("could not be shown to exist"), std::string::npos) << symmetric.coverage.reason;
}

// log det by Cholesky of the matrix scaled to unit diagonal, and what rounding may change in it.
struct LogDeterminant {
  double value, error;
};

LogDeterminant log_determinant(const Matrix& a) {
  const Vector scale = a.diagonal().cwiseSqrt().cwiseInverse();
  const Matrix unit = scale.asDiagonal() * a * scale.asDiagonal();
  const Matrix l = lapack::Cholesky(unit).lower();
  const double smallest = small::symmetric_eigenvalues(unit)(0);
  const double n = static_cast<double>(a.rows());
  return {2 * l.diagonal().array().log().sum() - 2 * scale.array().log().sum(), 8 * n * n * epsilon / std::max(smallest, n * epsilon)};
}

// K > 0: Π ω_i² = det K / det M, whatever G.
TEST(Properties, ProductOfFrequenciesIsTheRatioOfDeterminants) {
  Index sharp = 0;
  for_each_system([&](const support::RandomSystem& d, std::mt19937_64&) {
    const ModesResult r = solved(d.system());
    if (r.stiffness.definiteness() != Definiteness::positive) return;
    const LogDeterminant k = log_determinant(d.stiffness);
    const LogDeterminant m = log_determinant(d.mass);
    double sum = 0;
    double tolerance = k.error + m.error;
    for (const Mode& mode : r.modes) {
      sum += 2 * std::log(mode.omega);
      tolerance += 2 * slack(mode, 1, d.mass.rows()) / mode.omega;
    }
    if (tolerance < 1e-9) ++sharp;
    EXPECT_LE(std::abs(sum - (k.value - m.value)), tolerance) << d.description;
  });
  EXPECT_GT(sharp, 40);
}

// X_iᴴ(H(ω_k) − H(ω_i))X_k = (ω_i − ω_k)·X_iᴴ((ω_i + ω_k)M − jG)X_k is a difference of residuals: orthogonality of
// energy, for all pairs of roots however close, in units of n ε.
TEST(Properties, EnergyIsOrthogonal) {
  double worst = 0;
  for_each_system([&](const support::RandomSystem& d, std::mt19937_64&) {
    const ModesResult r = solved(d.system(), Method::automatic, true);
    const double n = static_cast<double>(d.mass.rows());
    const auto norm1 = [](const Matrix& a) { return a.cwiseAbs().colwise().sum().maxCoeff(); };
    const auto scale = [&](double w) { return norm1(d.stiffness) + w * norm1(d.gyroscopic) + w * w * norm1(d.mass); };
    for (const Mode& a : r.modes) {
      for (const Mode& b : r.modes) {
        if (!(a.omega < b.omega)) continue;
        const Complex form = (a.omega + b.omega) * a.shape.dot(d.mass * b.shape) - Complex(0, 1) * a.shape.dot(d.gyroscopic * b.shape);
        const double size = (scale(a.omega) + scale(b.omega)) * a.shape.norm() * b.shape.norm();
        const double ratio = (b.omega - a.omega) * std::abs(form) / (size * n * epsilon);
        worst = std::max(worst, ratio);
        EXPECT_LE(ratio, 10) << d.description << ", " << a.omega << " and " << b.omega;
      }
    }
  });
  RecordProperty("worst", std::to_string(worst));
}

// n₋(H(σ)) by plain eigenvalues, and whether it is beyond doubt.
std::pair<Index, bool> inertia_at(const System& s, double sigma) {
  const Vector d = s.mass().diagonal().cwiseSqrt().cwiseInverse();
  const ComplexMatrix h = d.asDiagonal() * s.impedance(sigma) * d.asDiagonal();
  const Vector e = small::hermitian_eigenvalues(h);
  return {(e.array() < 0).count(), e.cwiseAbs().minCoeff() > 1e-11 * e.cwiseAbs().maxCoeff()};
}

TEST(Properties, CountsAtRandomCuts) {
  Index windows = 0, twins = 0, uncounted = 0;
  for_each_system([&](const support::RandomSystem& d, std::mt19937_64& source) {
    const System system = d.system();
    const ModesResult all = solved(system);
    if (all.modes.empty() || all.modes.back().omega == 0) return;
    std::uniform_real_distribution<double> cut(0, 1.2 * all.modes.back().omega);
    for (int draw = 0; draw < 3; ++draw) {
      double a = cut(source), b = cut(source);
      if (a > b) std::swap(a, b);
      if (draw == 0) a = 0;
      ModesOptions options;
      options.window = {a, b};
      const ModesResult r = find_modes(system, options);
      const CountResult c = count_modes(system, {a, b});
      ++windows;
      if (r.coverage.status != CoverageStatus::complete) {
        ++uncounted;
        continue;
      }
      const Index expected =
          std::count_if(all.modes.begin(), all.modes.end(), [&](const Mode& m) { return r.coverage.window.contains(m.omega); });
      EXPECT_EQ(static_cast<Index>(r.modes.size()), expected) << d.description;
      EXPECT_EQ(*r.coverage.counted, expected) << d.description;
      EXPECT_EQ(c.status, CountStatus::exact) << d.description;
      EXPECT_EQ(c.count, expected) << d.description;
      EXPECT_EQ(c.negative[1] - c.negative[0], c.signed_count) << d.description;
      const auto [low, low_sure] = inertia_at(system, r.coverage.window.a);
      const auto [high, high_sure] = inertia_at(system, r.coverage.window.b);
      if (a == 0 || !low_sure || !high_sure) continue;
      ++twins;
      EXPECT_EQ(c.negative[0], low) << d.description;
      EXPECT_EQ(c.negative[1], high) << d.description;
    }
  });
  EXPECT_GT(twins, windows / 3);
  EXPECT_LE(uncounted, windows / 50);
}

}  // namespace
}  // namespace gyromode
