// The n × n real form of any system by a unitary matrix: its eigenvalues are ω², its transformation is unitary and
// symplectic, and motions obey it.
#include "support/random_matrices.h"
#include "gyromode/dense/unitary_form.h"
#include "gyromode/lapack/small.h"
#include "gyromode/system/laws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gyromode::dense {
namespace {

using support::Source;

constexpr double epsilon = 2.220446049250313e-16;

// λ² of the companion matrix, every second one.
std::vector<Complex> squares(const System& s) {
  const Index n = s.size();
  Matrix a = Matrix::Zero(2 * n, 2 * n);
  a.topRightCorner(n, n).setIdentity();
  a.bottomLeftCorner(n, n) = -small::solve(s.mass(), s.stiffness());
  a.bottomRightCorner(n, n) = -small::solve(s.mass(), s.gyroscopic());
  const Matrix a2 = a * a;
  const ComplexVector values = small::eigenvalues(a2);
  return {values.begin(), values.end()};
}

class UnitaryFormOf : public testing::TestWithParam<std::tuple<Index, Index, double>> {};

TEST_P(UnitaryFormOf, HasTheSquaresOfAllFrequencies) {
  const auto [n, negative, spin] = GetParam();
  Source source{std::mt19937_64(31)};
  const System s(source.symmetric(n, 0), spin * source.skew(n), source.symmetric(n, std::min(negative, n)));
  const UnitaryForm f = unitary_form(s);
  const double order = static_cast<double>(n);

  EXPECT_EQ(f.w.rows(), n);
  for (Index j = 0; j < n; ++j) {
    for (Index i = j + 2; i < n; ++i) EXPECT_EQ(f.w(i, j), 0);
  }
  EXPECT_LE((f.q1.transpose() * f.q1 + f.q2.transpose() * f.q2 - Matrix::Identity(n, n)).norm(), 20 * order * epsilon);
  EXPECT_LE((f.q1.transpose() * f.q2 - f.q2.transpose() * f.q1).norm(), 20 * order * epsilon);

  // Each ω² once where −ω² is a root twice.
  const auto truth = squares(s);
  const double size = f.w.norm();
  const ComplexVector found = small::eigenvalues(f.w);
  for (const Complex& w : found) {
    double nearest = size;
    for (const Complex& z : truth) nearest = std::min(nearest, std::abs(z + w));
    EXPECT_LE(nearest, 1e-6 * size) << w;  // double roots of the twin are known to √ε
  }
  EXPECT_NEAR(
      f.w.trace(),
      -0.5 *
          [&] {
            Complex sum = 0;
            for (const Complex& z : truth) sum += z;
            return sum.real();
          }(),
      1e3 * order * epsilon * size);

  // v̈ = −Wᵀv for v = Dq + Vq̇: with q̈ = −M⁻¹(Gq̇ + Kq), for every q and q̇. v̇ = Dq̇ + Vq̈ = D₁q + V₁q̇, and once more.
  const Matrix g = small::solve(s.mass(), s.gyroscopic()), k = small::solve(s.mass(), s.stiffness());
  const auto rate = [&](const Matrix& d, const Matrix& v) -> std::pair<Matrix, Matrix> { return {-v * k, d - v * g}; };
  const auto [d1, v1] = rate(f.displacement, f.velocity);
  const auto [d2, v2] = rate(d1, v1);
  EXPECT_LE((d2 + f.w.transpose() * f.displacement).norm(),
            200 * order * epsilon * size * (f.displacement.norm() + std::sqrt(size) * f.velocity.norm()));
  EXPECT_LE((v2 + f.w.transpose() * f.velocity).norm(), 200 * order * epsilon * size * (f.displacement.norm() + f.velocity.norm()));
}

INSTANTIATE_TEST_SUITE_P(AnyStiffness, UnitaryFormOf,
                         testing::Combine(testing::Values(Index{1}, Index{2}, Index{3}, Index{6}, Index{41}),
                                          testing::Values(Index{0}, Index{1}, Index{4}, Index{41}), testing::Values(0.1, 1.0, 10.0)));

}  // namespace
}  // namespace gyromode::dense
