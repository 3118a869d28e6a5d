#include "systems.h"

#include "gyromode/dense/mass_normal.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/system/laws.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <cmath>
#include <random>

namespace gyromode::bench {

namespace {

class Source {
 public:
  explicit Source(std::uint64_t seed) : engine_(seed) {}

  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine_); }

  Matrix gaussian(Index rows, Index columns) {
    std::normal_distribution<double> normal;
    Matrix a(rows, columns);
    for (double& x : a.reshaped()) x = normal(engine_);
    return a;
  }

  Matrix orthogonal(Index n) { return lapack::orthogonal_completion(gaussian(n, n)); }

  Matrix positive_definite(Index n, double condition) {
    const Matrix q = orthogonal(n);
    return symmetric_part(lapack::multiply_nt(q * graded(n, condition).asDiagonal(), q));
  }

  /// Condition as given; Q₁ diag Q₂.
  Matrix regular(Index n, double condition) { return lapack::multiply(orthogonal(n) * graded(n, condition).asDiagonal(), orthogonal(n)); }

 private:
  static Vector graded(Index n, double condition) { return Vector::LinSpaced(n, 0, -std::log(condition)).array().exp(); }

  std::mt19937_64 engine_;
};

constexpr double moderate = 1e3;

Matrix diagonal_blocks(const Matrix& a, const Matrix& b) {
  Matrix c = Matrix::Zero(a.rows() + b.rows(), a.cols() + b.cols());
  c.topLeftCorner(a.rows(), a.cols()) = a;
  c.bottomRightCorner(b.rows(), b.cols()) = b;
  return c;
}

Matrix across(const Matrix& b) {
  const Index p = b.rows();
  const Index r = b.cols();
  Matrix g = Matrix::Zero(p + r, p + r);
  g.topRightCorner(p, r) = b;
  g.bottomLeftCorner(r, p) = -b.transpose();
  return g;
}

// ‖L⁻¹ G L⁻ᵀ‖² = ‖L⁻¹ K L⁻ᵀ‖ in 2-norms, M = L Lᵀ.
Matrix comparable(const Matrix& g, const Matrix& m, const Matrix& k) {
  const dense::MassNormal normal(m);
  const Matrix gamma = normal.gyroscopic(g);
  const double gyroscopic2 = lapack::symmetric_eigenvalues(lapack::gram(gamma)).maxCoeff();
  const double elastic = lapack::symmetric_eigenvalues(normal.stiffness(k)).maxCoeff();
  return g * std::sqrt(elastic / gyroscopic2);
}

struct Pair {
  double k1, k2, b;
};

Pair random_pair(Source& source, Balance balance) {
  const double k1 = std::exp(source.uniform(std::log(0.01), 0));
  const double k2 = std::exp(source.uniform(std::log(0.01), 0));
  const double limit = std::sqrt(k1) + std::sqrt(k2);
  const double above = limit * source.uniform(1.1, 2);
  const double kind = source.uniform(0, 1);
  if (kind < 0.7) return {k1, k2, source.uniform(0.1, 2)};
  if (balance == Balance::stabilised || kind < 0.8) return {-k1, -k2, above};
  if (kind < 0.9) return {k1, -k2, source.uniform(0.1, 2)};
  return {-k1, -k2, limit * source.uniform(std::abs(std::sqrt(k1) - std::sqrt(k2)) / limit, 0.9)};  // complex ω² above |√|k₁| − √|k₂||
}

}  // namespace

System quadrature_definite(Index n, double condition, std::uint64_t seed) {
  Source source(seed);
  const Index p = n / 2;
  const Matrix m1 = source.positive_definite(p, moderate), m2 = source.positive_definite(n - p, moderate);
  const Matrix k1 = source.positive_definite(p, condition), k2 = source.positive_definite(n - p, condition);
  const Matrix m = diagonal_blocks(m1, m2), k = diagonal_blocks(k1, k2);
  return System(m, comparable(across(source.gaussian(p, n - p)), m, k), k);
}

System general_definite(Index n, std::uint64_t seed) {
  Source source(seed);
  const Matrix m = source.positive_definite(n, moderate), k = source.positive_definite(n, moderate);
  return System(m, comparable(skew_part(source.gaussian(n, n)), m, k), k);
}

System quadrature_indefinite(Index n, Balance balance, std::uint64_t seed) {
  Source source(seed);
  const Index p = n / 2;
  Vector k1(p), k2(p), b(p);
  for (Index i = 0; i < p; ++i) {
    const Pair pair = random_pair(source, balance);
    k1(i) = pair.k1;
    k2(i) = pair.k2;
    b(i) = pair.b;
  }
  const Matrix s1 = source.regular(p, std::sqrt(moderate)), s2 = source.regular(p, std::sqrt(moderate));
  const auto onto = [](const Matrix& left, const Vector& d, const Matrix& right) {
    return lapack::multiply_tn(left, d.asDiagonal() * right);
  };
  const Vector one = Vector::Ones(p);
  return System(symmetric_part(diagonal_blocks(onto(s1, one, s1), onto(s2, one, s2))), across(onto(s1, b, s2)),
                symmetric_part(diagonal_blocks(onto(s1, k1, s1), onto(s2, k2, s2))));
}

Matrix random_symmetric(Index n, std::uint64_t seed) { return symmetric_part(Source(seed).gaussian(n, n)); }

namespace {

// Second differences squared, clamped and free: the stiffness of a chain of m masses that resists bending.
Matrix bending(Index m) {
  Matrix d = Matrix::Zero(m, m);
  for (Index i = 0; i < m; ++i) {
    d(i, i) = 1;
    if (i >= 1) d(i, i - 1) = -2;
    if (i >= 2) d(i, i - 2) = 1;
  }
  return d.transpose() * d;
}

// K − Ω²M in both directions, G = 2ΩJM.
System spinning_beam(Index n, const Matrix& t) {
  const Index m = n / 2;
  const Matrix k = bending(m);
  const double spin2 = 100 * Eigen::SelfAdjointEigenSolver<Matrix>(k, Eigen::EigenvaluesOnly).eigenvalues()(0);
  Matrix stiffness = Matrix::Zero(2 * m, 2 * m), g = Matrix::Zero(2 * m, 2 * m);
  stiffness.topLeftCorner(m, m) = k - spin2 * Matrix::Identity(m, m);
  stiffness.bottomRightCorner(m, m) = 1.5 * k - spin2 * Matrix::Identity(m, m);
  g.bottomLeftCorner(m, m) = 2 * std::sqrt(spin2) * Matrix::Identity(m, m);
  g.topRightCorner(m, m) = -g.bottomLeftCorner(m, m);
  return System(Matrix::Identity(2 * m, 2 * m), skew_part(t * g * t.transpose()), symmetric_part(t * stiffness * t.transpose()));
}

}  // namespace

System general_indefinite(Index n, Regime regime, std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> size(0.5, 2);
  const auto gaussian_matrix = [&](Index rows) {
    Matrix a(rows, rows);
    for (double& x : a.reshaped()) x = normal(bits);
    return a;
  };
  const auto orthogonal_matrix = [&](Index rows) { return Matrix(Eigen::HouseholderQR<Matrix>(gaussian_matrix(rows)).householderQ()); };
  if (regime == Regime::beam) return spinning_beam(n, orthogonal_matrix(n));
  const Index own = regime == Regime::copies ? n / 2 : n;
  Vector d(own);
  for (Index i = 0; i < own; ++i)
    d(i) = size(bits) * (i < own / 10 ? -1 : 1) *
           (regime == Regime::graded ? std::pow(10.0, 8.0 * static_cast<double>(i) / static_cast<double>(own)) : 1);
  const Matrix q = orthogonal_matrix(own);
  Matrix k = symmetric_part(q * d.asDiagonal() * q.transpose());
  Matrix g = gaussian_matrix(own);
  g = (g - g.transpose()).eval() / std::sqrt(2.0 * static_cast<double>(own)) *
      (regime == Regime::spin20 ? 20
       : regime == Regime::huge ? 1e6
                                : 1);
  Matrix m = Matrix::Identity(n, n);
  if (regime == Regime::copies) {
    const Matrix t = orthogonal_matrix(n);
    const auto twice = [&](const Matrix& a) {
      Matrix b = Matrix::Zero(n, n);
      b.topLeftCorner(own, own) = b.bottomRightCorner(own, own) = a;
      return Matrix(t * b * t.transpose());
    };
    k = symmetric_part(twice(k));
    g = skew_part(twice(g));
  }
  if (regime == Regime::mixed) {
    std::uniform_int_distribution<int> exponent(-20, 20);
    Vector unit(n);
    for (double& x : unit) x = std::ldexp(1.0, exponent(bits));
    const auto mixed = [&](const Matrix& a) { return Matrix(unit.asDiagonal() * a * unit.asDiagonal()); };
    m = mixed(m);
    g = mixed(g);
    k = mixed(k);
  }
  return System(m, g, k);
}

}  // namespace gyromode::bench
