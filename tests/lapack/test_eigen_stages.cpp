// The stages of the symmetric eigenvalue problem and of the left singular vectors, against LAPACK's drivers and closed
// forms.
#include "support/random_matrices.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/divide_conquer.h"
#include "gyromode/lapack/rank_one_join.h"
#include "gyromode/lapack/reflectors.h"
#include "gyromode/lapack/singular.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/team.h"
#include "gyromode/lapack/tridiagonal.h"
#include "gyromode/lapack/small.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace gyromode::lapack {
namespace {

double unit(Index n) { return 20 * static_cast<double>(n + 1) * epsilon; }

using support::gaussian;

Matrix symmetric(std::mt19937_64& source, Index n) {
  const Matrix a = gaussian(source, n, n);
  return 0.5 * (a + a.transpose());
}

Matrix tridiagonal(const Vector& d, const Vector& e) {
  Matrix t = d.asDiagonal();
  if (e.size() > 0) t.diagonal(1) = t.diagonal(-1) = e;
  return t;
}

void expect_eigen(const Matrix& a, const SymmetricEigen& e, const std::string& what) {
  const Index n = a.rows();
  EXPECT_LE((a * e.vectors - e.vectors * e.values.asDiagonal()).norm(), unit(n) * a.norm()) << what;
  EXPECT_LE((e.vectors.transpose() * e.vectors - Matrix::Identity(n, n)).norm(), unit(n)) << what;
  EXPECT_TRUE(std::is_sorted(e.values.begin(), e.values.end())) << what;
  const Vector twin = small::symmetric_eigenvalues(a);
  EXPECT_LE((e.values - twin).norm(), unit(n) * a.norm()) << what;
}

// Q by its definition, one reflector after the other.
Matrix accumulated(const Reflectors& q) {
  const Index n = q.size();
  Matrix result = Matrix::Identity(n, n);
  for (Index k = 0; k < q.tau.size(); ++k) {
    Vector v = Vector::Zero(n);
    v(k + q.first) = 1;
    v.tail(n - k - q.first - 1) = q.vectors.col(k).tail(n - k - q.first - 1);
    result -= q.tau(k) * (result * v) * v.transpose();
  }
  return result;
}

Reflectors random_reflectors(std::mt19937_64& source, Index n, Index first) {
  Reflectors q{gaussian(source, n, n), Vector(n - first), first};
  for (Index k = 0; k < n - first; ++k) {
    const Index below = n - k - first - 1;
    q.tau(k) = k % 7 == 3 ? 0 : 2 / (1 + q.vectors.col(k).tail(below).squaredNorm());
    q.vectors.col(k).head(n - below).setConstant(std::numeric_limits<double>::quiet_NaN());  // not to be read
  }
  return q;
}

TEST(Reflectors, AreTheProductOfTheirFactorsFromBothSides) {
  std::mt19937_64 source(1);
  for (const Index n : {1, 2, 3, 63, 64, 65, 66, 130, 200}) {
    for (const Index first : {Index{0}, Index{1}}) {
      const Reflectors q = random_reflectors(source, n, first);
      const Matrix expected = accumulated(q);
      Matrix right = gaussian(source, 5, n);
      Matrix left = gaussian(source, n, 4);
      const Matrix xq = right * expected;
      const Matrix qx = expected * left;
      multiply_right(right, q);
      multiply_left(q, left);
      EXPECT_LE((right - xq).norm(), unit(n) * xq.norm()) << n << ", first " << first;
      EXPECT_LE((left - qx).norm(), unit(n) * qx.norm()) << n << ", first " << first;
    }
  }
}

TEST(Reflectors, OfLargeOrderByTheTeam) {
  std::mt19937_64 source(2);
  const Reflectors q = random_reflectors(source, 520, 1);
  Matrix left = Matrix::Identity(520, 520);
  Matrix right = left;
  multiply_left(q, left);
  multiply_right(right, q);
  EXPECT_LE((left - right).norm(), unit(520));
  EXPECT_LE((left.transpose() * left - Matrix::Identity(520, 520)).norm(), unit(520));
}

TEST(Tridiagonal, CountsWhatItsEigenvaluesSay) {
  std::mt19937_64 source(3);
  for (const Index n : {0, 1, 2, 5, 40}) {
    const Tridiagonal t(symmetric(source, n));
    const Vector values = t.eigen().values;
    for (Index i = 0; i + 1 < n; ++i) EXPECT_EQ(t.below(0.5 * (values(i) + values(i + 1))), i + 1);
    if (n > 0) {
      EXPECT_EQ(t.below(values(0) - 1), 0);
      EXPECT_EQ(t.below(values(n - 1) + 1), n);
    }
  }
  EXPECT_EQ(Tridiagonal(Matrix::Zero(3, 3)).below(1e-300), 3);
  EXPECT_EQ(Tridiagonal(Matrix::Zero(3, 3)).below(-1e-300), 0);
}

TEST(Tridiagonal, SizesNearTheEndsOfTheRange) {
  std::mt19937_64 source(4);
  const Matrix a = symmetric(source, 30);
  for (const double scale : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    const Tridiagonal t(scale * a);
    SymmetricEigen e = t.eigen();
    e.values /= scale;
    expect_eigen(a, e, "scale " + std::to_string(std::log10(scale)));
    EXPECT_EQ(t.below(0), (e.values.array() < 0).count());
  }
}

// diag(T₁, T₂) + coupling at the cut, whose halves are solved by Eigen: the join by itself, whatever the number of
// threads.
SymmetricEigen joined(const Vector& d, const Vector& e, Index cut) {
  const Index n = d.size();
  const double rho = e(cut - 1);
  Vector halves = d;
  halves(cut - 1) -= std::abs(rho);
  halves(cut) -= std::abs(rho);
  Matrix q = Matrix::Zero(n, n);
  Vector values(n);
  const auto solve = [&](Index first, Index size) {
    const SymmetricEigen half = small::symmetric_eigen(tridiagonal(halves.segment(first, size), e.segment(first, size - 1)));
    values.segment(first, size) = half.values;
    q.block(first, first, size, size) = half.vectors;
  };
  solve(0, cut);
  solve(cut, n - cut);
  join_rank_one(values, q, cut, rho);
  return {values, q};
}

TEST(RankOneJoin, OfRandomHalves) {
  std::mt19937_64 source(5);
  for (Index n = 2; n <= 60; ++n) {
    const Vector d = gaussian(source, n, 1) / 4;
    const Vector e = gaussian(source, n - 1, 1) / 4;
    for (const Index cut : {Index{1}, n / 2})
      expect_eigen(tridiagonal(d, e), joined(d, e, cut), std::to_string(n) + " cut at " + std::to_string(cut));
  }
}

TEST(RankOneJoin, DeflatesWhatDoesNotMeet) {
  std::mt19937_64 source(6);
  const Vector d = gaussian(source, 20, 1) / 4;
  Vector e = gaussian(source, 19, 1) / 4;
  for (const double coupling : {0.0, 1e-18, 1e-9, -0.5}) {
    e(9) = coupling;
    expect_eigen(tridiagonal(d, e), joined(d, e, 10), "coupling " + std::to_string(coupling));
  }
  expect_eigen(Matrix::Identity(12, 12), joined(Vector::Ones(12), Vector::Zero(11), 6), "all equal");
  const Vector repeated = Vector::Constant(30, 0.5);  // 1/2 + cos(kπ/31)/2, each from both halves nearly
  expect_eigen(tridiagonal(repeated, Vector::Constant(29, 0.25)), joined(repeated, Vector::Constant(29, 0.25), 15), "Toeplitz");
}

// Wilkinson's matrices have pairs that agree to the last digit.
TEST(TridiagonalEigen, LargeOrders) {
  const Index n = 601;
  const Vector wilkinson = Vector::LinSpaced(n, -300, 300).cwiseAbs();
  expect_eigen(tridiagonal(wilkinson, Vector::Ones(n - 1)), tridiagonal_eigen(wilkinson, Vector::Ones(n - 1)), "Wilkinson");
  const SymmetricEigen e = tridiagonal_eigen(Vector::Constant(n, 2e-9), Vector::Constant(n - 1, -1e-9));
  for (Index k = 0; k < n; ++k) {
    const double exact = 4e-9 * std::pow(std::sin(0.5 * std::numbers::pi * static_cast<double>(k + 1) / static_cast<double>(n + 1)), 2);
    EXPECT_NEAR(e.values(k), exact, unit(n) * 4e-9);
  }
  EXPECT_EQ(tridiagonal_eigen(Vector::Zero(n), Vector::Zero(n - 1)).values, Vector::Zero(n));
}

TEST(LeftSingular, AgreesWithTheDecomposition) {
  std::mt19937_64 source(7);
  for (const Index n : {0, 1, 2, 9, 70}) {
    const Matrix a = gaussian(source, n, n);
    const LeftSingular s = left_singular(a);
    if (n == 0) continue;
    EXPECT_LE((s.values - small::singular_values(a.cast<Complex>())).norm(), unit(n) * a.norm());
    const Matrix product = s.vectors.transpose() * a * a.transpose() * s.vectors;
    EXPECT_LE((product - Matrix(s.values.cwiseAbs2().asDiagonal())).norm(), unit(n) * a.squaredNorm());
    EXPECT_LE((s.vectors.transpose() * s.vectors - Matrix::Identity(n, n)).norm(), unit(n));
  }
}

TEST(Team, EveryPartOnceAndEveryRoundInTurn) {
  for (const int threads : {1, 2, 3, 5}) {
    Team team(threads);
    ASSERT_EQ(team.size(), threads);
    std::vector<int> rounds(static_cast<std::size_t>(threads), 0);
    for (int round = 0; round < 500; ++round) {
      team.run([&](int part) { ++rounds[static_cast<std::size_t>(part)]; });
      for (const int done : rounds) ASSERT_EQ(done, round + 1);
    }
    Index sum = 0;
    for (int part = 0; part < threads; ++part) {
      EXPECT_EQ(team.begin(101, part), sum);
      sum += team.count(101, part);
    }
    EXPECT_EQ(sum, 101);
  }
}

}  // namespace
}  // namespace gyromode::lapack
