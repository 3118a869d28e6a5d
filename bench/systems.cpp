#include "systems.h"

#include "gyromode/dense/mass_normal.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/system/promise.h"

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
  const auto onto = [](const Matrix& left, const Vector& d, const Matrix& right) { return lapack::multiply_tn(left, d.asDiagonal() * right); };
  const Vector one = Vector::Ones(p);
  return System(symmetric_part(diagonal_blocks(onto(s1, one, s1), onto(s2, one, s2))), across(onto(s1, b, s2)),
                symmetric_part(diagonal_blocks(onto(s1, k1, s1), onto(s2, k2, s2))));
}

Matrix random_symmetric(Index n, std::uint64_t seed) { return symmetric_part(Source(seed).gaussian(n, n)); }

}  // namespace gyromode::bench
