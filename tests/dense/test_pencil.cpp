// Self-adjoint pencils: real roots of definite ones, conjugate pairs of indefinite ones, nothing of singular ones.
#include "support/random_matrices.h"
#include "gyromode/base/rounding.h"
#include "gyromode/dense/pencil.h"
#include "gyromode/lapack/small.h"

#include <gtest/gtest.h>

#include <numeric>
#include <algorithm>
#include <cmath>
#include <random>

namespace gyromode::dense {
namespace {

using support::Source;

ComplexMatrix hermitian(Source& source, Index n) {
  ComplexMatrix a(n, n);
  a.real() = source.gaussian(n, n);
  a.imag() = source.gaussian(n, n);
  return 0.5 * (a + a.adjoint());
}

double pencil_residual(const ComplexMatrix& a, const ComplexMatrix& b, const PencilRoot& r) {
  return (a * r.y - r.value * (b * r.y)).norm() / ((a.norm() + std::abs(r.value) * b.norm()) * static_cast<double>(a.rows()) * epsilon);
}

TEST(SelfAdjointPencil, DefiniteIsRealAndOrthogonal) {
  Source source{std::mt19937_64(17)};
  for (Index n = 1; n <= 8; ++n) {
    for (const double sign : {1.0, -1.0}) {
      const ComplexMatrix a = hermitian(source, n);
      const ComplexMatrix h = hermitian(source, n);
      const ComplexMatrix b = sign * (h * h + ComplexMatrix::Identity(n, n));
      const auto roots = self_adjoint_pencil(a, b);
      ASSERT_EQ(static_cast<Index>(roots.size()), n);
      for (const PencilRoot& r : roots) {
        EXPECT_EQ(r.value.imag(), 0);
        EXPECT_NEAR(r.y.norm(), 1, 10 * epsilon);
        EXPECT_LE(pencil_residual(a, b, r), 50);
        EXPECT_NEAR(r.form, std::real(r.y.dot(b * r.y)), 50 * static_cast<double>(n) * epsilon * b.norm());
        for (const PencilRoot& other : roots) {
          if (&other != &r) {
            EXPECT_LE(std::abs(other.y.dot(b * r.y)), 50 * static_cast<double>(n) * epsilon * b.norm());
          }
        }
      }
    }
  }
}

TEST(SelfAdjointPencil, IndefiniteComesInConjugatePairs) {
  Source source{std::mt19937_64(18)};
  Index complex = 0;
  for (int draw = 0; draw < 300; ++draw) {
    const Index n = source.integer(2, 7);
    const ComplexMatrix a = hermitian(source, n);
    const ComplexMatrix b = source.symmetric(n, source.integer(1, n - 1)).cast<Complex>();
    const auto roots = self_adjoint_pencil(a, b);
    ASSERT_EQ(static_cast<Index>(roots.size()), n);
    Index balance = 0;
    for (const PencilRoot& r : roots) {
      if (r.value.imag() == 0) {
        balance += r.form > 0 ? 1 : -1;
      } else {
        ++complex;
        EXPECT_TRUE(std::any_of(roots.begin(), roots.end(), [&](const PencilRoot& o) { return o.value == std::conj(r.value); }))
            << "draw " << draw;
        EXPECT_GT(r.form, 0);
      }
      EXPECT_LE(pencil_residual(a, b, r), 100) << "draw " << draw;
    }
    const Vector beta = small::hermitian_eigenvalues(b);
    EXPECT_EQ(balance, (beta.array() > 0).count() - (beta.array() < 0).count()) << "signature of B, draw " << draw;
  }
  EXPECT_GT(complex, 50);
}

TEST(SelfAdjointPencil, SaysNothingOfASingularForm) {
  Source source{std::mt19937_64(19)};
  EXPECT_TRUE(self_adjoint_pencil(hermitian(source, 3), ComplexMatrix::Zero(3, 3)).empty());
  ComplexMatrix b = ComplexMatrix::Zero(3, 3);
  b(0, 0) = 1;
  b(1, 1) = -1;
  EXPECT_TRUE(self_adjoint_pencil(hermitian(source, 3), b).empty());
}

// The contract is "empty where B is singular to rounding": an indefinite B singular but for rounding still gets roots,
// of size 1/ε, near which nothing is known.
TEST(SelfAdjointPencil, SaysNothingOfAFormSingularToRounding) {
  Source source{std::mt19937_64(22)};
  const Matrix q = source.orthogonal(3);
  const Matrix b = q * Vector{{1, -1, 0}}.asDiagonal() * q.transpose();
  EXPECT_TRUE(self_adjoint_pencil(hermitian(source, 3), (0.5 * (b + b.transpose())).cast<Complex>()).empty());
}

}  // namespace
}  // namespace gyromode::dense
