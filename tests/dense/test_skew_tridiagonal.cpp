// The skew tridiagonalisation against its slow twins: Z = Q T Qᵀ rebuilt, Q orthogonal, and the product kernel against
// the product.
#include "support/random_matrices.h"

#include "gyromode/base/rounding.h"
#include "gyromode/dense/general/skew_multiply.h"
#include "gyromode/dense/general/skew_tridiagonal.h"
#include "gyromode/lapack/small.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace gyromode::dense {
namespace {

using support::gaussian;

Matrix skew(std::mt19937_64& source, Index n) {
  const Matrix a = gaussian(source, n, n);
  return 0.5 * (a - a.transpose());
}

// What the class may read of Z: the rest is NaN, which would show.
Matrix lower_only(Matrix z) {
  z.triangularView<Eigen::Upper>().setConstant(std::numeric_limits<double>::quiet_NaN());
  return z;
}

Matrix tridiagonal(const Vector& beta) {
  const Index n = beta.size() + 1;
  Matrix t = Matrix::Zero(n, n);
  t.diagonal(-1) = beta;
  t.diagonal(1) = -beta;
  return t;
}

Matrix orthogonal_factor(const SkewTridiagonal& s) {
  Matrix q = Matrix::Identity(s.size(), s.size());
  lapack::multiply_right(q, s.q());
  return q;
}

struct Ratios {
  double rebuilt = 0;     // ‖Z − Q T Qᵀ‖ / (n ε ‖Z‖)
  double orthogonal = 0;  // ‖QᵀQ − 1‖ / (n ε)
};

Ratios ratios(const Matrix& z) {
  const SkewTridiagonal s(lower_only(z));
  const Matrix q = orthogonal_factor(s);
  const double unit = static_cast<double>(z.rows()) * epsilon;
  const double difference = (z - q * tridiagonal(s.subdiagonal()) * q.transpose()).norm();
  const double size = z.norm();
  return {size > 0 ? difference / (unit * size) : difference, (q.transpose() * q - Matrix::Identity(z.rows(), z.rows())).norm() / unit};
}

// n₀(n ε): what a sequence of n reflectors may leave; the measured worst is below 3 for n ≥ 2.
constexpr double limit = 5;

void expect_small(const Ratios& r, Index n) {
  EXPECT_TRUE(r.rebuilt <= limit) << "n = " << n << ", rebuilt " << r.rebuilt;
  EXPECT_TRUE(r.orthogonal <= limit) << "n = " << n << ", orthogonal " << r.orthogonal;
}

TEST(SkewMultiply, IsTheProductWithTheTrailingBlock) {
  std::mt19937_64 source(1);
  for (Index n = 1; n <= 70; ++n) {
    const Matrix z = skew(source, n);
    const Matrix stored = lower_only(z);
    for (const Index first : {Index{0}, Index{1}, Index{2}, Index{3}, n / 3, n / 2, n - 1}) {
      if (first >= n) continue;
      const Index m = n - first;
      const Vector v = gaussian(source, m, 1);
      Vector y = Vector::Constant(m + 1, 7.25);  // overwritten, and one guard behind it
      skew_multiply(stored, first, v.data(), y.data());
      EXPECT_EQ(y(m), 7.25);
      const auto block = z.bottomRightCorner(m, m);
      const Vector bound = block.cwiseAbs() * v.cwiseAbs();
      for (Index i = 0; i < m; ++i) {
        EXPECT_LE(std::abs(y(i) - block.row(i).dot(v)), 2 * static_cast<double>(m) * epsilon * bound(i))
            << "n = " << n << ", first = " << first;
      }
    }
  }
}

TEST(SkewMultiply, ZeroVectorsAndIntegersAreExact) {
  std::mt19937_64 source(2);
  const Matrix z = (4 * skew(source, 23)).array().round();
  const Vector v = (5 * gaussian(source, 20, 1)).array().round();
  Vector y(20);
  skew_multiply(lower_only(z), 3, v.data(), y.data());
  EXPECT_EQ(y, z.bottomRightCorner(20, 20) * v);
  EXPECT_EQ(v.dot(y), 0) << "vᵀZv = 0";
  skew_multiply(lower_only(z), 3, Vector::Zero(20).eval().data(), y.data());
  EXPECT_TRUE(y.isZero(0));
}

TEST(SkewTridiagonal, RebuildsEveryOrderAcrossThePanels) {
  std::mt19937_64 source(3);
  for (Index n = 1; n <= 130; ++n) expect_small(ratios(skew(source, n)), n);
}

TEST(SkewTridiagonal, OfOrderNoneAndOne) {
  EXPECT_EQ(SkewTridiagonal(Matrix(0, 0)).subdiagonal().size(), 0);
  const SkewTridiagonal one(Matrix::Zero(1, 1));
  EXPECT_EQ(one.subdiagonal().size(), 0);
  EXPECT_EQ(orthogonal_factor(one), Matrix::Identity(1, 1));
}

TEST(SkewTridiagonal, LeavesZeroAndTridiagonalMatricesAlone) {
  std::mt19937_64 source(4);
  for (const Index n : {2, 3, 47, 48, 49, 50, 97, 130}) {
    const SkewTridiagonal zero(Matrix::Zero(n, n));
    EXPECT_TRUE(zero.subdiagonal().isZero(0));
    EXPECT_EQ(orthogonal_factor(zero), Matrix::Identity(n, n));
    const Vector beta = gaussian(source, n - 1, 1);
    const SkewTridiagonal same(lower_only(tridiagonal(beta)));
    EXPECT_EQ(same.subdiagonal(), beta) << "n = " << n;
    EXPECT_EQ(orthogonal_factor(same), Matrix::Identity(n, n)) << "n = " << n;
  }
}

TEST(SkewTridiagonal, ZeroColumnsInsideAndDecoupledBlocks) {
  std::mt19937_64 source(5);
  for (const Index n : {6, 49, 96, 101}) {
    Matrix z = skew(source, n);
    for (Index k = 0; k < n; k += 5) {
      z.row(k).setZero();
      z.col(k).setZero();
    }
    expect_small(ratios(z), n);
    Matrix blocks = skew(source, n);
    blocks.bottomLeftCorner(n - n / 2, n / 2).setZero();
    blocks.topRightCorner(n / 2, n - n / 2).setZero();
    expect_small(ratios(blocks), n);
  }
}

TEST(SkewTridiagonal, GradedBothWays) {
  std::mt19937_64 source(6);
  for (const Index n : {5, 20, 48, 49, 90, 130}) {
    Vector d(n);
    for (Index i = 0; i < n; ++i) d(i) = std::pow(10.0, -12.0 * static_cast<double>(i) / static_cast<double>(n - 1));
    const Matrix z = skew(source, n);
    expect_small(ratios(d.asDiagonal() * z * d.asDiagonal()), n);
    expect_small(ratios(d.reverse().asDiagonal() * z * d.reverse().asDiagonal()), n);
  }
}

// Large enough for a team of threads where there is more than one processor.
TEST(SkewTridiagonal, LargeOrdersByTheTeam) {
  std::mt19937_64 source(10);
  for (const Index n : {513, 700}) expect_small(ratios(skew(source, n)), n);
}

TEST(SkewMultiply, TeamsOfAnySizeAgree) {
  std::mt19937_64 source(11);
  const Index n = 450;
  const Matrix z = skew(source, n);
  const Vector v = gaussian(source, n, 1);
  for (const int threads : {1, 2, 3}) {
    lapack::Team team(threads);
    SkewMultiply multiply(team, n);
    for (const Index first : {0, 7, 300}) {
      Vector y(n - first);
      multiply(z, first, v.data(), y.data());
      const Vector expected = z.bottomRightCorner(n - first, n - first) * v.head(n - first);
      EXPECT_LE((y - expected).norm(), static_cast<double>(n) * epsilon * expected.norm()) << threads << " threads from " << first;
    }
    for (int part = 0; part < threads; ++part) EXPECT_LE(equal_area(n, part, threads), equal_area(n, part + 1, threads));
    EXPECT_EQ(equal_area(n, 0, threads), 0);
    EXPECT_EQ(equal_area(n, threads, threads), n);
  }
}

// Powers of two are exact, far from under- and overflow of squares.
TEST(SkewTridiagonal, DoesNotDependOnTheUnit) {
  std::mt19937_64 source(7);
  const Matrix z = skew(source, 61);
  const SkewTridiagonal plain(z);
  for (const int power : {-300, -30, 30, 300}) {
    const SkewTridiagonal scaled(std::ldexp(1.0, power) * z);
    EXPECT_EQ(scaled.subdiagonal(), std::ldexp(1.0, power) * plain.subdiagonal()) << "2^" << power;
    EXPECT_EQ(orthogonal_factor(scaled), orthogonal_factor(plain)) << "2^" << power;
  }
}

TEST(SkewTridiagonal, MultipliesFromTheRight) {
  std::mt19937_64 source(8);
  for (const Index n : {1, 2, 30, 48, 49, 50, 96, 97, 130}) {
    const SkewTridiagonal s(skew(source, n));
    const Matrix q = orthogonal_factor(s);
    for (const Index rows : {Index{1}, n / 2 + 1, n + 7}) {
      const Matrix x = gaussian(source, rows, n);
      Matrix xq = x;
      lapack::multiply_right(xq, s.q());
      EXPECT_LE((xq - x * q).norm(), limit * static_cast<double>(n) * epsilon * x.norm()) << "n = " << n << ", rows = " << rows;
    }
  }
}

// det Z = Pf(Z)² = (β₁β₃ …)² for even n, det Q = ±1.
TEST(SkewTridiagonal, KeepsThePfaffian) {
  std::mt19937_64 source(9);
  for (const Index n : {2, 4, 10, 50, 100}) {
    const Matrix z = skew(source, n);
    const Vector beta = SkewTridiagonal(z).subdiagonal();
    double log_pfaffian = 0;
    for (Index k = 0; k < n; k += 2) log_pfaffian += std::log(std::abs(beta(k)));
    const double log_det = small::pivots(z.cast<Complex>()).values.cwiseAbs().array().log().sum();
    EXPECT_NEAR(2 * log_pfaffian, log_det, 10 * static_cast<double>(n) * epsilon / small::reciprocal_condition(z)) << "n = " << n;
  }
}

}  // namespace
}  // namespace gyromode::dense
