// Families of systems with pairs of frequencies from 1e-2 down to 1e-14 apart, in every class: two systems of one kind,
// the second 1 + δ times as fast, in coordinates that mix them. None may be lost, none invented, and what is
// determined, the span of a pair, must be right where its vectors cannot be.
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"
#include "gyromode/modes/modes.h"
#include "gyromode/modes/spacecraft.h"
#include "support/random_matrices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace gyromode;
using support::Source;

namespace {

const std::vector<double> gaps{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13, 1e-14};

enum class Kind { quadrature, hidden, general, stabilised, opposite };
constexpr Kind kinds[] = {Kind::quadrature, Kind::hidden, Kind::general, Kind::stabilised, Kind::opposite};
constexpr const char* names[] = {"quadrature", "hidden", "general", "stabilised", "opposite energies"};

Matrix twice(const Matrix& a, double factor) {
  Matrix both = Matrix::Zero(2 * a.rows(), 2 * a.cols());
  both.topLeftCorner(a.rows(), a.cols()) = a;
  both.bottomRightCorner(a.rows(), a.cols()) = factor * a;
  return both;
}

struct Family {
  System system;
  System one;  // the slow half, unmixed
};

// M = 1; the second half has G(1 + δ), K(1 + δ)².
Family family(Kind kind, double delta, std::uint64_t seed) {
  Source s{std::mt19937_64(seed)};
  const Index n = 4, p = 2;
  Matrix k = s.symmetric(n, 0), g = s.skew(n);
  if (kind == Kind::quadrature || kind == Kind::hidden) {
    k.topRightCorner(p, n - p).setZero();
    k.bottomLeftCorner(n - p, p).setZero();
    g.topLeftCorner(p, p).setZero();
    g.bottomRightCorner(n - p, n - p).setZero();
  }
  if (kind == Kind::stabilised || kind == Kind::opposite) {
    k = -s.symmetric(n, 0);
    g = Matrix::Zero(n, n);
    g(0, 1) = 7, g(1, 0) = -7, g(2, 3) = 11, g(3, 2) = -11;
  }
  Matrix t = s.orthogonal(2 * n);
  if (kind == Kind::quadrature) {  // mixes only what moves in phase
    t.setZero();
    const Matrix a = s.orthogonal(2 * p), b = s.orthogonal(2 * (n - p));
    const std::vector<Index> first{0, 1, 4, 5}, second{2, 3, 6, 7};
    t(first, first) = a;
    t(second, second) = b;
  }
  Matrix whole_k = twice(k, (1 + delta) * (1 + delta)), whole_g = twice(g, 1 + delta);
  if (kind == Kind::opposite) {  // −K and −G: the same frequencies with K > 0 and energies of the other sign, not coupled
    const Matrix positive = s.symmetric(n, 0);
    whole_k = Matrix::Zero(2 * n, 2 * n);
    whole_k.topLeftCorner(n, n) = k;
    const ModesResult slow = find_modes(System(Matrix::Identity(n, n), g, k));
    for (Index i = 0; i < n; ++i) whole_k(n + i, n + i) = std::pow(slow.modes[static_cast<std::size_t>(i)].omega * (1 + delta), 2);
    whole_g = Matrix::Zero(2 * n, 2 * n);
    whole_g.topLeftCorner(n, n) = g;
  }
  const System mixed(Matrix::Identity(2 * n, 2 * n), skew_part(t.transpose() * whole_g * t), symmetric_part(t.transpose() * whole_k * t));
  return {mixed, System(Matrix::Identity(n, n), g, k)};
}

// ‖H applied to the span of a pair‖ in the sense of its own 2 × 2 matrix: min over B of ‖K V + G V B + M V B²‖ with V
// orthonormal is what an invariant pair must make small.
double invariant_pair_residual(const System& s, const ComplexMatrix& x, const Eigen::Vector2d& omega) {
  const ComplexMatrix v = small::orthonormal_columns(x);
  const ComplexMatrix r = v.adjoint() * x;
  const Eigen::Matrix2cd b =
      r * Eigen::Vector2cd(Complex(0, omega(0)), Complex(0, omega(1))).asDiagonal() * small::solve(r, ComplexMatrix::Identity(2, 2));
  return (s.stiffness() * v + s.gyroscopic() * v * b + s.mass() * v * b * b).norm();
}

}  // namespace

class CloseFrequencies : public testing::TestWithParam<int> {};

TEST_P(CloseFrequencies, NoneLostNoneInvented) {
  const Kind kind = kinds[GetParam()];
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const double delta : gaps) {
      const Family f = family(kind, delta, seed);
      const std::string what = std::string(names[GetParam()]) + ", seed " + std::to_string(seed) + ", gap " + std::to_string(delta);
      ModesOptions options;
      options.shapes = true;
      const ModesResult r = find_modes(f.system, options);
      const ModesResult slow = find_modes(f.one);
      std::vector<double> exact;
      for (const Mode& m : slow.modes) {
        exact.push_back(m.omega);
        exact.push_back(m.omega * (1 + delta));
      }
      std::sort(exact.begin(), exact.end());
      // Opposite energies within rounding: marginal, and said so.
      const bool marginal = r.stability == Stability::marginal;
      if (marginal) {
        EXPECT_TRUE(kind == Kind::opposite && delta <= 1e-10) << what;  // the slow half is itself near its threshold in some
      } else {
        EXPECT_EQ(to_string(r.coverage.status), "complete") << what << ": " << r.coverage.reason;
      }
      EXPECT_TRUE(r.unstable.empty()) << what;
      ASSERT_EQ(r.modes.size(), exact.size()) << what;
      for (std::size_t i = 0; i < exact.size(); ++i) {
        EXPECT_LE(std::abs(r.modes[i].omega - exact[i]), std::max(r.modes[i].error_bound, 64 * epsilon * exact[i]) * 4)
            << what << ", mode " << i + 1;
        EXPECT_LE(r.modes[i].residual, 30 * 8 * epsilon) << what;
      }
      if (!marginal) {
        for (std::size_t i = 0; i < exact.size(); i += 2) {
          ComplexMatrix x(f.system.size(), 2);
          x << r.modes[i].shape.normalized(), r.modes[i + 1].shape.normalized();
          const double independent = small::singular_values(x)(1);
          EXPECT_GE(independent, 1e-3) << what << ": the two shapes of a pair point the same way";
          EXPECT_LE(invariant_pair_residual(f.system, x, {r.modes[i].omega, r.modes[i + 1].omega}), 1e-11 * f.system.stiffness().norm())
              << what;
        }
      }
      for (const Mode& m : r.modes) {
        if (delta >= 1e-8) {
          EXPECT_EQ(m.cluster, 1) << what;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Classes, CloseFrequencies, testing::Range(0, 5), [](const auto& p) {
  std::string name = names[p.param];
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST(CloseFrequenciesFirstOrder, NoneLostNoneInvented) {
  Source s{std::mt19937_64(9)};
  for (const double delta : gaps) {
    const Matrix g = s.skew(4), t = s.orthogonal(8);
    const FirstOrderSystem system(Matrix::Identity(8, 8), skew_part(t.transpose() * twice(g, 1 + delta) * t));
    const ModesResult r = find_modes(system), slow = find_modes(FirstOrderSystem(Matrix::Identity(4, 4), g));
    EXPECT_EQ(to_string(r.coverage.status), "complete") << delta;
    ASSERT_EQ(r.modes.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      const double exact = slow.modes[i / 2].omega * (i % 2 == 0 ? 1 : 1 + delta);
      EXPECT_NEAR(r.modes[i].omega, exact, 64 * epsilon * exact) << delta;
    }
  }
}

// Exact booms: four wires of which one pair is δ longer. Every mode of the axial pattern and of the plane comes in
// close company.
TEST(CloseFrequenciesSpacecraft, WiresDetuned) {
  constexpr double pi = std::numbers::pi;
  std::size_t expected = 0;
  for (const double delta : gaps) {
    std::vector<Cable> wires;
    for (int i = 0; i < 4; ++i) {
      Cable c;
      c.azimuth = i * pi / 2;
      c.radius = 1;
      c.length = 40 * (i % 2 == 0 ? 1 : 1 + delta);
      c.line_density = 2e-3;
      c.tip_mass = 0.05;
      wires.push_back(c);
    }
    Body body;
    body.mass = 300;
    body.inertia = Eigen::Vector3d(150, 150, 250).asDiagonal();
    const Spacecraft craft(0.3, body, wires);
    ModesOptions options;
    options.window.b = 15 * craft.spin();
    const ModesResult r = find_modes(craft, options);
    EXPECT_EQ(to_string(r.coverage.status), "complete") << delta << ": " << r.coverage.reason;
    if (expected == 0) expected = r.modes.size();
    EXPECT_EQ(r.modes.size(), expected) << delta;
    EXPECT_EQ(static_cast<Index>(r.modes.size()), *r.coverage.counted) << delta;
    for (std::size_t i = 1; i < r.modes.size(); ++i) EXPECT_GE(r.modes[i].omega, r.modes[i - 1].omega);
  }
}
