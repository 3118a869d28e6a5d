// Each dense solver against its slow twin: the 2n companion matrix, the pseudo-inverse of theory (T10), singular values, exact ranks.
#include "gyromode/dense/definite.h"
#include "gyromode/dense/ignorable.h"
#include "gyromode/dense/indefinite.h"
#include "gyromode/dense/mass_normal.h"
#include "gyromode/dense/pencil.h"
#include "gyromode/dense/quadrature.h"
#include "gyromode/dense/refine.h"
#include "gyromode/dense/solve.h"
#include "gyromode/certificate/assess.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>

namespace gyromode::dense {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Source {
  std::mt19937_64 bits;

  Index integer(Index a, Index b) { return std::uniform_int_distribution<Index>(a, b)(bits); }
  Matrix gaussian(Index rows, Index cols) {
    std::normal_distribution<double> normal;
    Matrix a(rows, cols);
    for (double& x : a.reshaped()) x = normal(bits);
    return a;
  }
  Matrix integers(Index rows, Index cols, Index most) {
    Matrix a(rows, cols);
    for (double& x : a.reshaped()) x = static_cast<double>(integer(-most, most));
    return a;
  }
  Matrix orthogonal(Index n) { return Eigen::HouseholderQR<Matrix>(gaussian(n, n)).householderQ() * Matrix::Identity(n, n); }
  Matrix skew(Index n) {
    const Matrix a = gaussian(n, n);
    return a - a.transpose();
  }
  // Symmetric with |eigenvalues| in [0.5, 2], `negative` of them below zero.
  Matrix symmetric(Index n, Index negative) {
    Vector d(n);
    for (Index i = 0; i < n; ++i) d(i) = std::uniform_real_distribution<double>(0.5, 2)(bits) * (i < negative ? -1 : 1);
    const Matrix q = orthogonal(n);
    const Matrix k = q * d.asDiagonal() * q.transpose();
    return 0.5 * (k + k.transpose());
  }
};

Matrix lower_root(const Matrix& k) { return Eigen::LLT<Matrix>(k).matrixL(); }

// ---- the companion twin -------------------------------------------------------------------------------------------------

ComplexVector all_roots(const Vector& omega, const std::vector<double>& divergence, const std::vector<Complex>& flutter) {
  std::vector<Complex> roots;
  for (const double w : omega) roots.insert(roots.end(), {{0, w}, {0, -w}});
  for (const double s : divergence) roots.insert(roots.end(), {{s, 0}, {-s, 0}});
  for (const Complex z : flutter) roots.insert(roots.end(), {z, std::conj(z), -z, -std::conj(z)});
  return Eigen::Map<ComplexVector>(roots.data(), static_cast<Index>(roots.size()));
}

// Every root of z̈ + Γż + kz = 0 is there: the largest |λ − λ_twin| in units of n ε ‖A‖ times the condition of the eigenvalue, each twin taken once.
double worst_root(const Matrix& gamma, const Matrix& k, ComplexVector found) {
  const Index n = k.rows();
  if (found.size() != 2 * n) return std::numeric_limits<double>::infinity();
  Matrix a = Matrix::Zero(2 * n, 2 * n);
  a << -gamma, -k, Matrix::Identity(n, n), Matrix::Zero(n, n);
  const Eigen::EigenSolver<Matrix> e(a);
  const ComplexMatrix left = e.eigenvectors().inverse();
  double worst = 0;
  for (Index i = 0; i < 2 * n; ++i) {
    Index at = 0;
    const double distance = (found.array() - e.eigenvalues()(i)).abs().minCoeff(&at);
    const double condition = left.row(i).norm() * e.eigenvectors().col(i).norm();
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
  EXPECT_LE(worst_root(gamma, k, all_roots(m.omega, m.divergence, m.flutter)), 4) << where << ": " << m.path;
  ComplexMatrix x(n, m.omega.size());
  x << m.x.cast<Complex>(), Complex(0, -1) * m.y.cast<Complex>();
  EXPECT_LE(worst_residual(gamma, k, m.omega, x), 100) << where << ": " << m.path;
  EXPECT_TRUE(std::is_sorted(m.omega.begin(), m.omega.end()));
  if (c.root1 || c.root2) {
    EXPECT_TRUE(m.flutter.empty());
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
  EXPECT_NE(m.path.find("singular values of C"), std::string::npos);
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
    EXPECT_LE(worst_root(gamma, k, all_roots(m.omega, {}, {})), 4) << "n = " << n;
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
      EXPECT_LE(worst_root(gamma, k, all_roots(m.omega, m.divergence, m.flutter)), 4) << "n = " << n;
      EXPECT_LE(worst_residual(gamma, k, m.omega, m.shapes), 100) << "n = " << n;
      flutter += static_cast<Index>(m.flutter.size());
      divergence += static_cast<Index>(m.divergence.size());
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

// ---- mass-normal coordinates ----------------------------------------------------------------------------------------------

TEST(MassNormal, Identities) {
  Source source{std::mt19937_64(14)};
  for (const Index n : {1, 2, 7, 40}) {
    const double unit = 50 * static_cast<double>(n) * epsilon;
    const Matrix m = source.symmetric(n, 0);
    const Matrix k = source.symmetric(n, 0);
    const Matrix g = source.skew(n);
    const Matrix b = source.gaussian(n, n + 1);
    const MassNormal normal(m);
    const MassNormal other(source.symmetric(n + 1, 0));
    Matrix phi = Matrix::Identity(n, n);
    normal.to_physical(phi);
    Matrix psi = Matrix::Identity(n + 1, n + 1);
    other.to_physical(psi);
    EXPECT_LE((phi.transpose() * m * phi - Matrix::Identity(n, n)).norm(), unit);
    EXPECT_LE((normal.stiffness(k) - phi.transpose() * k * phi).norm(), unit * k.norm());
    EXPECT_LE((normal.gyroscopic(g) - phi.transpose() * g * phi).norm(), unit * g.norm());
    EXPECT_LE((normal.coupling(b, other) - phi.transpose() * b * psi).norm(), unit * b.norm());
    const Matrix f = normal.stiffness_root(k);
    EXPECT_LE((f * f.transpose() - normal.stiffness(k)).norm(), unit * k.norm());
    EXPECT_TRUE(f.isLowerTriangular(0));
    EXPECT_EQ(normal.stiffness(k), normal.stiffness(k).transpose());
    EXPECT_EQ(normal.gyroscopic(g), -normal.gyroscopic(g).transpose());
    Matrix back = phi;
    normal.to_normal(back);
    EXPECT_LE((back - Matrix::Identity(n, n)).norm(), unit);

    // Units of coordinates by powers of two cost not a bit.
    Vector d(n);
    for (Index i = 0; i < n; ++i) d(i) = std::ldexp(1.0, static_cast<int>(source.integer(-40, 40)));
    const MassNormal mixed(d.asDiagonal() * m * d.asDiagonal());
    EXPECT_EQ(mixed.stiffness(d.asDiagonal() * k * d.asDiagonal()), normal.stiffness(k));
    EXPECT_EQ(mixed.stiffness_root(d.asDiagonal() * k * d.asDiagonal()), f);
  }
}

// ---- ignorable coordinates --------------------------------------------------------------------------------------------------

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
  const Eigen::SelfAdjointEigenSolver<Matrix> e(k);
  const Vector& d = e.eigenvalues();
  ZeroCount z;
  z.negative = (d.array() < -tiny).count();
  z.null = (d.array().abs() <= tiny).count();
  const Vector inverse_d = d.unaryExpr([](double x) { return std::abs(x) <= tiny ? 0 : 1 / x; });
  const Matrix pseudo_inverse = e.eigenvectors() * inverse_d.asDiagonal() * e.eigenvectors().transpose();
  const Matrix null = e.eigenvectors().middleCols(z.negative, z.null);
  const Eigen::JacobiSVD<Matrix> svd(null.transpose() * gamma * null, Eigen::ComputeFullV);
  const Index rank2 = (svd.singularValues().array() > tiny).count();
  z.coupled = rank2 / 2;
  const Matrix kept = null * svd.matrixV().rightCols(z.null - rank2);
  const Matrix f = kept.transpose() * (Matrix::Identity(n, n) + gamma.transpose() * pseudo_inverse * gamma) * kept;
  const Vector values = f.rows() > 0 ? Vector(Eigen::SelfAdjointEigenSolver<Matrix>(f).eigenvalues()) : Vector();
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
    while (r < n && std::abs(b.determinant()) < 0.5) b = source.integers(n - r, n - r, 1) + 2 * Matrix::Identity(n - r, n - r);
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
    Matrix null = Matrix::Zero(n, r);  // exact: the threshold on NᵀΓN is 8 n ε‖Γ‖
    for (Index i = 0; i < n; ++i) {
      if (order[static_cast<std::size_t>(i)] < r) null(i, order[static_cast<std::size_t>(i)]) = 1;
    }
    const Deflation d = deflate({gamma, k, -1}, {null, r, twin.negative});
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
    EXPECT_EQ(d.ignorable + d.negative + d.gyroscopic_null.cols() / 2, twin.negative_at_zero) << what;
  }
  EXPECT_GT(irregular, 5);
  EXPECT_GT(coupled, 200);
  EXPECT_GT(uncoupled, 200);
}

// ---- first order --------------------------------------------------------------------------------------------------------------

TEST(FirstOrder, FrequenciesAreSingularValues) {
  Source source{std::mt19937_64(16)};
  for (Index n = 1; n <= 40; ++n) {
    for (const bool blocks : {false, true}) {
      Matrix inertia = source.symmetric(n, 0);
      Matrix g = source.skew(n);
      const Index p = source.integer(0, n);
      if (blocks) {
        inertia.topRightCorner(p, n - p).setZero();
        inertia.bottomLeftCorner(n - p, p).setZero();
        g.topLeftCorner(p, p).setZero();
        g.bottomRightCorner(n - p, n - p).setZero();
      }
      const FirstOrderSystem system(inertia, g);
      std::vector<double> found;
      Index zeros = 0;
      for (const Component& c : analyse(system).components) {
        const Spectrum s = solve(system, c);
        found.insert(found.end(), s.omega.begin(), s.omega.end());
        zeros += s.zero_pairs();
        EXPECT_LE((g(s.order, s.order) * s.zero_shapes).norm(), 50 * static_cast<double>(n) * epsilon * g.norm());
      }
      std::sort(found.begin(), found.end(), std::greater<>());
      const Eigen::LLT<Matrix> l(inertia);
      Matrix skew = l.matrixL().solve(g);
      skew = l.matrixL().solve(skew.transpose().eval()).transpose().eval();
      const Vector twin = Eigen::JacobiSVD<Matrix>(skew).singularValues();  // each frequency twice
      ASSERT_EQ(2 * static_cast<Index>(found.size()) + zeros, n);
      for (Index i = 0; i < n; ++i) {
        const double expected = i / 2 < static_cast<Index>(found.size()) ? found[static_cast<std::size_t>(i / 2)] : 0;
        EXPECT_NEAR(twin(i), expected, 10 * static_cast<double>(n) * epsilon * (twin(0) + 1)) << "n = " << n << ", blocks " << blocks;
      }
    }
  }
}

// ---- projected pencils ----------------------------------------------------------------------------------------------------------

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
        EXPECT_TRUE(std::any_of(roots.begin(), roots.end(), [&](const PencilRoot& o) { return o.value == std::conj(r.value); })) << "draw " << draw;
        EXPECT_GT(r.form, 0);
      }
      EXPECT_LE(pencil_residual(a, b, r), 100) << "draw " << draw;
    }
    const Vector beta = Eigen::SelfAdjointEigenSolver<ComplexMatrix>(b).eigenvalues();
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

// ---- refinement -------------------------------------------------------------------------------------------------------------------

System refinable(Source& source, Index n, bool quadrature, Index negative) {
  Matrix m = source.symmetric(n, 0), k = source.symmetric(n, negative), g = 2 * source.skew(n);
  const Index p = n / 2;
  if (quadrature) {
    for (Matrix* a : {&m, &k}) {
      a->topRightCorner(p, n - p).setZero();
      a->bottomLeftCorner(n - p, p).setZero();
    }
    g.topLeftCorner(p, p).setZero();
    g.bottomRightCorner(n - p, n - p).setZero();
  }
  return System(m, g, k);
}

// Distance to the nearest other root, mirror images at −ω among them.
double gap_of(const Spectrum& s, Index i) {
  double gap = s.omega(i);
  for (Index k = 0; k < s.omega.size(); ++k) {
    if (k != i) gap = std::min(gap, std::abs(s.omega(k) - s.omega(i)));
  }
  return gap;
}

void perturb(Source& source, Spectrum& s, Index i, double step, double amount) {
  s.omega(i) += step;
  s.re.col(i) += amount * s.re.norm() * source.gaussian(s.re.rows(), 1);
  s.im.col(i) += amount * s.im.norm() * source.gaussian(s.im.rows(), 1);
}

TEST(Refine, BringsAPerturbedRootBackToRounding) {
  Source source{std::mt19937_64(20)};
  for (int draw = 0; draw < 80; ++draw) {
    const Index n = source.integer(2, 12);
    const System system = refinable(source, n, draw % 2 == 0, draw % 4 < 2 ? 0 : n);
    for (const Component& c : analyse(system).components) {
      Spectrum s = solve(system, c);
      const Impedance h(system, s);
      assess(h, s);
      const Spectrum exact = s;
      for (Index i = 0; i < s.omega.size(); ++i) {
        const double gap = gap_of(exact, i);
        if (gap < 1e-2 * exact.omega(i)) continue;
        perturb(source, s, i, 1e-4 * gap, 1e-5);
        EXPECT_TRUE(refine(h, s, {i}, 0.3 * gap)) << "draw " << draw;
        const Assessment a = measure(h, s);
        EXPECT_LE(a.residual(i), 10 * static_cast<double>(n) * epsilon) << "draw " << draw << ", root " << i;
        EXPECT_LE(std::abs(s.omega(i) - exact.omega(i)), 10 * static_cast<double>(n) * epsilon * a.sensitivity(i)) << "draw " << draw << ", root " << i;
        s = exact;
      }
    }
  }
}

TEST(Refine, NeverJumpsToANeighbour) {
  Source source{std::mt19937_64(21)};
  for (int draw = 0; draw < 80; ++draw) {
    const Index n = source.integer(3, 12);
    const System system = refinable(source, n, draw % 2 == 0, draw % 4 < 2 ? 0 : n);
    for (const Component& c : analyse(system).components) {
      Spectrum s = solve(system, c);
      const Impedance h(system, s);
      const Spectrum exact = s;
      for (Index i = 0; i + 1 < s.omega.size(); ++i) {
        const double gap = exact.omega(i + 1) - exact.omega(i);
        for (const double way : {0.3, 0.5, 0.7}) {
          // Started on the way to the neighbour, which is out of reach.
          const double start = exact.omega(i) + way * gap;
          const double reach = 0.9 * (1 - way) * gap;
          perturb(source, s, i, way * gap, 0.1);
          refine(h, s, {i}, reach);
          EXPECT_LE(std::abs(s.omega(i) - start), reach * (1 + 1e-9)) << "draw " << draw << ", root " << i << ", way " << way;
          EXPECT_EQ(s.omega(i + 1), exact.omega(i + 1));
          s = exact;
        }
      }
    }
  }
}

// The contract is "empty where B is singular to rounding": an indefinite B singular but for rounding still gets roots, of size 1/ε, near which nothing is known.
TEST(SelfAdjointPencil, SaysNothingOfAFormSingularToRounding) {
  Source source{std::mt19937_64(22)};
  const Matrix q = source.orthogonal(3);
  const Matrix b = q * Vector{{1, -1, 0}}.asDiagonal() * q.transpose();
  EXPECT_TRUE(self_adjoint_pencil(hermitian(source, 3), (0.5 * (b + b.transpose())).cast<Complex>()).empty());
}

}  // namespace
}  // namespace gyromode::dense
