// The removal of zero roots against exact ranks in integers and the pseudo-inverse of theory (T10).
#include "support/random_matrices.h"
#include "gyromode/dense/ignorable.h"
#include "gyromode/lapack/small.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace gyromode::dense {
namespace {

using support::Source;

// Rank modulo the prime 2³¹ − 1 of an integer matrix: the true rank but for rare chance.
constexpr std::int64_t prime = 2147483647;
using Integers = Eigen::Matrix<std::int64_t, Eigen::Dynamic, Eigen::Dynamic>;

std::int64_t inverse(std::int64_t a) {
  std::int64_t result = 1;
  for (std::int64_t power = prime - 2; power > 0; power /= 2, a = a * a % prime) {
    if (power % 2 == 1) result = result * a % prime;
  }
  return result;
}

Index rank(Integers a) {
  Index r = 0;
  for (Index c = 0; c < a.cols() && r < a.rows(); ++c) {
    Index pivot = r;
    while (pivot < a.rows() && a(pivot, c) == 0) ++pivot;
    if (pivot == a.rows()) continue;
    a.row(r).swap(a.row(pivot));
    const std::int64_t over = inverse(a(r, c));
    for (Index i = r + 1; i < a.rows(); ++i) {
      const std::int64_t factor = a(i, c) * over % prime;
      for (Index j = c; j < a.cols(); ++j) a(i, j) = ((a(i, j) - factor * a(r, j)) % prime + prime) % prime;
    }
    ++r;
  }
  return r;
}

// Half the algebraic multiplicity of λ = 0: the nullity of A^(2n), A the companion matrix.
Index exact_zero_pairs(const Matrix& gamma, const Matrix& k) {
  const Index n = k.rows();
  Matrix a(2 * n, 2 * n);
  a << -gamma, -k, Matrix::Identity(n, n), Matrix::Zero(n, n);
  Integers power = a.cast<std::int64_t>().unaryExpr([](std::int64_t x) { return (x % prime + prime) % prime; });
  for (Index reached = 1; reached < 2 * n; reached *= 2) {
    Integers square = Integers::Zero(2 * n, 2 * n);
    for (Index i = 0; i < 2 * n; ++i) {
      for (Index j = 0; j < 2 * n; ++j) {
        for (Index l = 0; l < 2 * n; ++l) square(i, j) = (square(i, j) + power(i, l) * power(l, j)) % prime;
      }
    }
    power = square;
  }
  return (2 * n - rank(power)) / 2;
}

struct ZeroCount {
  Index negative = 0;                                 // n₋(K)
  Index null = 0, coupled = 0, negative_at_zero = 0;  // r, s, n₋(H(0⁺)) of theory (T10)
  bool regular = true;                                // F is nonsingular
};

ZeroCount by_pseudo_inverse(const Matrix& gamma, const Matrix& k) {
  constexpr double tiny = 1e-9;
  const Index n = k.rows();
  const lapack::SymmetricEigen e = small::symmetric_eigen(k);
  const Vector& d = e.values;
  ZeroCount z;
  z.negative = (d.array() < -tiny).count();
  z.null = (d.array().abs() <= tiny).count();
  const Vector inverse_d = d.unaryExpr([](double x) { return std::abs(x) <= tiny ? 0 : 1 / x; });
  const Matrix pseudo_inverse = e.vectors * inverse_d.asDiagonal() * e.vectors.transpose();
  const Matrix null = e.vectors.middleCols(z.negative, z.null);
  const small::Svd svd = small::singular_value_decomposition((null.transpose() * gamma * null).cast<Complex>());
  const Index rank2 = (svd.values.array() > tiny).count();
  z.coupled = rank2 / 2;
  const Matrix kept = null * svd.v.real().rightCols(z.null - rank2);
  const Matrix f = kept.transpose() * (Matrix::Identity(n, n) + gamma.transpose() * pseudo_inverse * gamma) * kept;
  const Vector values = f.rows() > 0 ? Vector(small::symmetric_eigenvalues(f)) : Vector();
  z.regular = (values.array().abs() > tiny).all();
  z.negative_at_zero = z.negative + z.coupled + (values.array() > 0).count();
  return z;
}

TEST(Deflation, TakesOutExactlyTheZeroRoots) {
  Source source{std::mt19937_64(15)};
  Index irregular = 0, coupled = 0, uncoupled = 0;
  for (int draw = 0; draw < 1500; ++draw) {
    const Index n = source.integer(1, 8);
    const Index r = source.integer(1, n);
    // k and Γ of small integers; r null directions at random coordinates, coupled by Γ or (every other draw) not.
    Matrix b = Matrix::Zero(n - r, n - r);
    while (r < n && std::abs(small::pivots(b.cast<Complex>()).values.prod()) < 0.5)
      b = source.integers(n - r, n - r, 1) + 2 * Matrix::Identity(n - r, n - r);
    Vector signs(n - r);
    for (double& s : signs) s = source.integer(0, 1) == 1 ? 1 : -1;
    Matrix k = Matrix::Zero(n, n);
    k.bottomRightCorner(n - r, n - r) = b * signs.asDiagonal() * b.transpose();
    Matrix gamma = source.integers(n, n, 2);
    gamma = (gamma - gamma.transpose()).eval();
    if (draw % 2 == 0) gamma.topLeftCorner(r, r).setZero();
    std::vector<Index> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), Index{0});
    std::shuffle(order.begin(), order.end(), source.bits);
    k = Matrix(k(order, order));
    gamma = Matrix(gamma(order, order));

    const ZeroCount twin = by_pseudo_inverse(gamma, k);
    ASSERT_EQ(twin.null, r);
    const Deflation d = deflate({Matrix::Identity(n, n), gamma, k, -1});
    const std::string what = "draw " + std::to_string(draw) + ", n = " + std::to_string(n) + ", r = " + std::to_string(twin.null);
    EXPECT_EQ(d.zero_pairs, exact_zero_pairs(gamma, k)) << what;
    EXPECT_EQ(d.reduced.size() - d.gyroscopic_null.cols() / 2 + d.zero_pairs, n) << what;
    if (!twin.regular) {
      ++irregular;
      continue;
    }
    ++(twin.coupled > 0 ? coupled : uncoupled);
    EXPECT_EQ(d.zero_pairs, twin.null - twin.coupled) << what;
    EXPECT_EQ(d.gyroscopic_null.cols(), 2 * twin.coupled) << what;
    EXPECT_EQ(d.ignorable + d.negative() + d.gyroscopic_null.cols() / 2, twin.negative_at_zero) << what;
  }
  EXPECT_GT(irregular, 5);
  EXPECT_GT(coupled, 200);
  EXPECT_GT(uncoupled, 200);
}

}  // namespace
}  // namespace gyromode::dense
