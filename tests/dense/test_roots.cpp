// The dense solvers against the plain eigenvalues of the companion matrix of order 2n.
#include "support/random_matrices.h"
#include "gyromode/base/rounding.h"
#include "gyromode/dense/general/definite.h"
#include "gyromode/dense/general/indefinite.h"
#include "gyromode/dense/quadrature/quadrature.h"
#include "gyromode/lapack/general.h"
#include "gyromode/lapack/small.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace gyromode::dense {
namespace {

using support::lower_root;
using support::Source;

ComplexVector all_roots(const Vector& omega, const UnstableRoots& unstable) {
  std::vector<Complex> roots;
  for (const double w : omega) roots.insert(roots.end(), {{0, w}, {0, -w}});
  for (const Complex z : unstable.lambda) {
    roots.insert(roots.end(), {z, -z});
    if (z.imag() != 0) roots.insert(roots.end(), {std::conj(z), -std::conj(z)});
  }
  return Eigen::Map<ComplexVector>(roots.data(), static_cast<Index>(roots.size()));
}

// Every root of z̈ + Γż + kz = 0 is there: the largest |λ − λ_twin| in units of n ε ‖A‖ times the condition of the
// eigenvalue, each twin taken once.
double worst_root(const Matrix& gamma, const Matrix& k, ComplexVector found) {
  const Index n = k.rows();
  if (found.size() != 2 * n) return std::numeric_limits<double>::infinity();
  Matrix a = Matrix::Zero(2 * n, 2 * n);
  a << -gamma, -k, Matrix::Identity(n, n), Matrix::Zero(n, n);
  const lapack::GeneralEigen e = lapack::general_eigen(a);
  const ComplexMatrix left = small::solve(e.vectors, ComplexMatrix::Identity(2 * n, 2 * n));
  double worst = 0;
  for (Index i = 0; i < 2 * n; ++i) {
    Index at = 0;
    const double distance = (found.array() - e.values(i)).abs().minCoeff(&at);
    const double condition = left.row(i).norm() * e.vectors.col(i).norm();
    worst = std::max(worst, distance / (static_cast<double>(n) * epsilon * a.norm() * condition));
    found(at) = std::numeric_limits<double>::infinity();
  }
  return worst;
}

// max ‖(k − ω² + jωΓ)X‖ / ((‖k‖ + ω‖Γ‖ + ω²)‖X‖) in units of n ε.
double worst_residual(const Matrix& gamma, const Matrix& k, const Vector& omega, const ComplexMatrix& x) {
  double worst = 0;
  for (Index i = 0; i < omega.size(); ++i) {
    const double w = omega(i);
    const ComplexVector r = k * x.col(i) + Complex(0, w) * (gamma * x.col(i)) - w * w * x.col(i);
    worst = std::max(worst, r.norm() / ((k.norm() + w * gamma.norm() + w * w) * x.col(i).norm()));
  }
  return worst / (static_cast<double>(k.rows()) * epsilon);
}

struct QuadratureCase {
  Index negative1, negative2;
  bool root1, root2;
};

void compare_quadrature(Source& source, Index p, Index r, const QuadratureCase& c) {
  const Index n = p + r;
  const std::string where = "p = " + std::to_string(p) + ", r = " + std::to_string(r);
  const auto block = [](const Matrix& k, bool root) { return root ? StiffnessBlock(k, lower_root(k)) : StiffnessBlock(k); };
  const Matrix b = source.gaussian(p, r);
  const Matrix k1 = source.symmetric(p, c.negative1);
  const Matrix k2 = source.symmetric(r, c.negative2);
  const QuadratureForm form{b, block(k1, c.root1), block(k2, c.root2)};
  Matrix gamma = Matrix::Zero(n, n);
  gamma.topRightCorner(p, r) = form.b;
  gamma.bottomLeftCorner(r, p) = -form.b.transpose();
  Matrix k = Matrix::Zero(n, n);
  k.topLeftCorner(p, p) = k1;
  k.bottomRightCorner(r, r) = k2;
  const QuadratureModes m = quadrature_modes(form);
  EXPECT_LE(worst_root(gamma, k, all_roots(m.omega, m.unstable)), 4) << where << ": " << m.solver;
  ComplexMatrix x(n, m.omega.size());
  x << m.x.cast<Complex>(), Complex(0, -1) * m.y.cast<Complex>();
  EXPECT_LE(worst_residual(gamma, k, m.omega, x), 100) << where << ": " << m.solver;
  EXPECT_TRUE(std::is_sorted(m.omega.begin(), m.omega.end()));
  if (c.root1 || c.root2) {
    for (Index i = 0; i < m.unstable.count(); ++i) EXPECT_TRUE(m.unstable.divergent(i));
  }
}

TEST(QuadratureModes, AgreeWithTheCompanionMatrix) {
  Source source{std::mt19937_64(11)};
  for (Index n = 2; n <= 40; ++n) {
    const Index p = source.integer(1, n - 1);
    const Index r = n - p;
    compare_quadrature(source, p, r, {0, 0, true, true});
    compare_quadrature(source, p, r, {0, source.integer(0, r), true, false});
    compare_quadrature(source, p, r, {source.integer(0, p), 0, false, true});
    compare_quadrature(source, p, r, {source.integer(1, p), source.integer(1, r), false, false});
  }
}

// Frequencies over six decades: C keeps what W loses. Closed form for b = 0: the square roots of k.
TEST(QuadratureModes, SmallFrequenciesBySingularValues) {
  const auto diagonal = [](double a, double b) { return Matrix(Vector{{a, b}}.asDiagonal()); };
  const QuadratureForm form{Matrix::Zero(2, 2), {diagonal(1e-12, 1), diagonal(1e-6, 1)}, {diagonal(1e-10, 4), diagonal(1e-5, 2)}};
  const QuadratureModes m = quadrature_modes(form);
  EXPECT_NE(m.solver.find("singular values of C"), std::string::npos);
  EXPECT_NEAR(m.omega(0), 1e-6, 4 * epsilon);
  EXPECT_NEAR(m.omega(1), 1e-5, 4 * epsilon);
  EXPECT_NEAR(m.omega(2), 1, 8 * epsilon);
  EXPECT_NEAR(m.omega(3), 2, 8 * epsilon);
}

TEST(DefiniteModes, AgreeWithTheCompanionMatrix) {
  Source source{std::mt19937_64(12)};
  for (Index n = 2; n <= 40; ++n) {
    const Matrix gamma = source.skew(n);
    const Matrix k = source.symmetric(n, 0);
    const ComplexModes m = definite_modes(gamma, lower_root(k));
    EXPECT_LE(worst_root(gamma, k, all_roots(m.omega, {})), 4) << "n = " << n;
    ComplexMatrix x(n, n);
    x.real() = m.re;
    x.imag() = m.im;
    EXPECT_LE(worst_residual(gamma, k, m.omega, x), 100) << "n = " << n;
  }
}

TEST(IndefiniteModes, AgreeWithTheCompanionMatrix) {
  Source source{std::mt19937_64(13)};
  Index flutter = 0, divergence = 0, negative_energy = 0;
  for (Index n = 2; n <= 40; ++n) {
    for (const double strength : {0.2, 1.0, 4.0}) {
      const Matrix gamma = strength * source.skew(n);
      const Matrix k = source.symmetric(n, source.integer(1, n));
      const IndefiniteModes m = indefinite_modes({gamma, k, -1}, Matrix(n, 0));
      EXPECT_LE(worst_root(gamma, k, all_roots(m.omega, m.unstable)), 4) << "n = " << n;
      EXPECT_LE(worst_residual(gamma, k, m.omega, m.shapes), 100) << "n = " << n;
      for (Index i = 0; i < m.unstable.count(); ++i) ++(m.unstable.divergent(i) ? divergence : flutter);
      for (Index i = 0; i < m.omega.size(); ++i) {
        const ComplexVector x = m.shapes.col(i);
        if (std::real(x.dot(2 * m.omega(i) * x - Complex(0, 1) * (gamma * x))) < 0) ++negative_energy;
      }
    }
  }
  EXPECT_GT(flutter, 20);  // the draw covers every kind of root
  EXPECT_GT(divergence, 20);
  EXPECT_GT(negative_energy, 20);
}

}  // namespace
}  // namespace gyromode::dense
