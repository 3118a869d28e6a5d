#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"
#include "gyromode/modes/spacecraft.h"
#include "gyromode/structure/realify.h"
#include "support/random_matrices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace gyromode;

namespace {

ComplexMatrix hermitian(support::Source& s, Index n) {
  ComplexMatrix h(n, n);
  h.real() = s.gaussian(n, n);
  h.imag() = s.gaussian(n, n);
  return 0.5 * (h + h.adjoint());
}

// ‖UᴴHU − H*‖/‖H‖ and ‖UᴴU − 1‖ in units of n ε. H* is a real matrix: it has no imaginary part to be measured.
void expect_exact(const Realified& r, double most = 30) {
  const double n = static_cast<double>(r.impedance.rows());
  const ComplexMatrix star = r.unitary.adjoint() * r.impedance * r.unitary;
  EXPECT_LE((star - r.real_symmetric.cast<Complex>()).norm(), most * n * epsilon * r.impedance.norm());
  EXPECT_LE((r.unitary.adjoint() * r.unitary - ComplexMatrix::Identity(r.unitary.cols(), r.unitary.cols())).norm(), most * n * epsilon);
  EXPECT_EQ((r.real_symmetric - r.real_symmetric.transpose()).norm(), 0);
}

Index negative_by_embedding(const ComplexMatrix& h) {
  const Index n = h.rows();
  Matrix a(2 * n, 2 * n);
  a << h.real(), -h.imag(), h.imag(), h.real();
  const Vector values = small::symmetric_eigenvalues(a);
  return (values.array() < 0).count() / 2;
}

}  // namespace

// Of H = D (±1 or a definite core) D with D graded over many decades the signs are those of the core, whatever
// transformation is printed; H* stays UᴴHU.
TEST(Realify, CountsOfGradedMatrices) {
  support::Source s{std::mt19937_64(7)};
  for (int trial = 0; trial < 600; ++trial) {
    const Index n = s.integer(1, 8), negative = s.integer(0, n);
    const Index most = 15 * s.integer(0, 3);
    ComplexMatrix core = s.symmetric(n, negative).cast<Complex>();  // |eigenvalues| in [½, 2]
    if (trial % 2 == 0) {
      const ComplexMatrix u = realify_by_reflections(hermitian(s, n)).unitary;
      core = u.adjoint() * core * u;
      core = (0.5 * (core + core.adjoint())).eval();
    }
    Vector d(n);
    for (double& x : d) x = std::exp2(static_cast<double>(s.integer(-most, most)));
    const ComplexMatrix h = d.asDiagonal() * core * d.asDiagonal();
    std::vector<Realified> all{realify_by_reflections(h)};
    if (n == 2) all.push_back(realify_by_angle(h));
    if (trial % 2 == 1) all.push_back(realify_by_partition(h, {}));
    for (const Realified& r : all) {
      expect_exact(r);
      EXPECT_EQ(r.negative(), negative) << trial << " " << to_string(r.how) << " grading 2^" << most;
      EXPECT_EQ(r.determinant_sign(), negative % 2 == 0 ? 1 : -1) << trial;
    }
  }
}

TEST(Realify, AnyHermitianMatrix) {
  support::Source s{std::mt19937_64(1)};
  for (const Index n : {1, 2, 3, 4, 7, 20, 60, 200}) {
    for (const double unit : {1e-200, 1e-9, 1.0, 1e9, 1e200}) {
      const ComplexMatrix h = unit * hermitian(s, n);
      const Realified r = realify_by_reflections(h);
      Realified scaled = r;
      scaled.impedance *= 1 / unit;
      scaled.real_symmetric /= unit;
      expect_exact(scaled);
      for (Index i = 0; i < n; ++i) {
        for (Index k = i + 2; k < n; ++k) ASSERT_EQ(r.real_symmetric(i, k), 0);
      }
      EXPECT_EQ(r.negative(), negative_by_embedding(h * (1 / unit)));
      EXPECT_EQ(r.determinant_sign(), r.negative() % 2 == 0 ? 1 : -1);
    }
  }
}

TEST(Realify, SpecialMatrices) {
  expect_exact(realify_by_reflections(ComplexMatrix::Zero(4, 4)));
  EXPECT_EQ(realify_by_reflections(ComplexMatrix::Zero(4, 4)).determinant_sign(), 0);
  expect_exact(realify_by_reflections(ComplexMatrix::Identity(5, 5)));
  ComplexMatrix imaginary = ComplexMatrix::Zero(3, 3);
  imaginary(0, 1) = Complex(0, 1), imaginary(1, 0) = Complex(0, -1), imaginary(1, 2) = Complex(0, -2), imaginary(2, 1) = Complex(0, 2);
  expect_exact(realify_by_reflections(imaginary));
  EXPECT_EQ(realify_by_reflections(imaginary).determinant_sign(), 0);  // odd skew
}

// (18) as corrected: c, not c/2, in the diagonal; the off-diagonal is b on both sides.
TEST(Realify, AngleAgainstEquation18) {
  support::Source s{std::mt19937_64(2)};
  for (int trial = 0; trial < 1000; ++trial) {
    const ComplexMatrix h = hermitian(s, 2);
    const Realified r = realify_by_angle(h);
    expect_exact(r);
    const double a = h(0, 0).real(), d = h(1, 1).real(), c = h(0, 1).real(), b = h(0, 1).imag(), psi = *r.angle;
    EXPECT_NEAR(r.real_symmetric(0, 1), b, 1e-15);
    EXPECT_NEAR((a - d) / 2 * std::sin(2 * psi), c * std::cos(2 * psi), 1e-14);  // (19)
    EXPECT_NEAR(std::tan(2 * psi) * (a - d), 2 * c, 1e-12 * (1 + std::abs(std::tan(2 * psi))));
    EXPECT_LE(std::abs(psi), std::numbers::pi / 4 * (1 + epsilon));
    // The same eigenvalues as by reflections.
    const Vector one = small::symmetric_eigenvalues(r.real_symmetric);
    const Vector two = small::symmetric_eigenvalues(realify_by_reflections(h).real_symmetric);
    EXPECT_LE((one - two).norm(), 30 * epsilon * h.norm());
    EXPECT_EQ(r.negative(), realify_by_reflections(h).negative());
  }
}

TEST(Realify, AngleWhereItIsNotDefined) {
  ComplexMatrix h(2, 2);
  h << 3, Complex(0, 2), Complex(0, -2), 3;  // a = d, c = 0: every angle serves
  EXPECT_EQ(*realify_by_angle(h).angle, 0);
  EXPECT_EQ(*realify_by_angle(h, 0.4).angle, 0.4);
  expect_exact(realify_by_angle(h, 0.4));
  h << 3, Complex(1, 2), Complex(1, -2), 3;  // a = d alone: 45°
  EXPECT_NEAR(*realify_by_angle(h).angle, std::numbers::pi / 4, 1e-15);
  h << 1, Complex(-0.0, 2), Complex(-0.0, -2), 3;  // c = 0: no turn, whatever the sign of zero
  EXPECT_NEAR(*realify_by_angle(h).angle, 0, 1e-15);
  EXPECT_THROW(realify_by_angle(ComplexMatrix::Identity(3, 3)), InvalidArgument);
}

// The branch is followed through a = d, where arctan jumps by 90°, and around a full turn.
TEST(Realify, AngleIsContinuousAlongOmega) {
  double psi = 0;
  for (int k = 0; k <= 1000; ++k) {
    const double t = 2 * std::numbers::pi * k / 1000;  // 2ψ turns once round
    ComplexMatrix h(2, 2);
    h << 2 + std::cos(t), Complex(std::sin(t), 0.3), Complex(std::sin(t), -0.3), 2 - std::cos(t);
    const Realified r = realify_by_angle(h, psi);
    EXPECT_NEAR(*r.angle, t / 2, 1e-12) << k;
    expect_exact(r);
    psi = *r.angle;
  }
}

// On a partitioned matrix T, S(ψ) and reflections agree: S(0) = T for n = 2, and all three have the eigenvalues of H.
TEST(Realify, PartitionIsASpecialCase) {
  support::Source s{std::mt19937_64(4)};
  for (const Index n : {2, 5, 12}) {
    const Index p = s.integer(1, n - 1);
    ComplexMatrix h = ComplexMatrix::Zero(n, n);
    h.topLeftCorner(p, p) = s.symmetric(p, 0).cast<Complex>();
    h.bottomRightCorner(n - p, n - p) = s.symmetric(n - p, (n - p) / 2).cast<Complex>();
    h.topRightCorner(p, n - p) = Complex(0, 1) * s.gaussian(p, n - p).cast<Complex>();
    h.bottomLeftCorner(n - p, p) = h.topRightCorner(p, n - p).adjoint();
    std::vector<Index> second;
    for (Index i = p; i < n; ++i) second.push_back(i);
    const Realified t = realify_by_partition(h, second), u = realify_by_reflections(h);
    expect_exact(t, 1);
    const Vector one = small::symmetric_eigenvalues(t.real_symmetric);
    const Vector two = small::symmetric_eigenvalues(u.real_symmetric);
    EXPECT_LE((one - two).norm(), 30 * static_cast<double>(n) * epsilon * h.norm());
    EXPECT_EQ(t.negative(), u.negative());
    if (n == 2) {
      const Realified a = realify_by_angle(h);
      EXPECT_EQ(*a.angle, 0);
      EXPECT_LE((a.unitary - t.unitary).norm(), epsilon);
      EXPECT_LE((a.real_symmetric - t.real_symmetric).norm(), epsilon * h.norm());
    }
  }
}

TEST(Realify, ChosenByTheStructure) {
  Matrix k{{4, 0.6}, {0.6, 7}};
  const Matrix g{{0, -1.2}, {1.2, 0}};
  const System turned(Matrix::Identity(2, 2), g, k);
  EXPECT_EQ(to_string(realify(turned.impedance(1.3), analyse(turned)).how), "angle");
  k(0, 1) = k(1, 0) = 0;
  const System plain(Matrix::Identity(2, 2), g, k);
  EXPECT_EQ(to_string(realify(plain.impedance(1.3), analyse(plain)).how), "partition");
  support::Source s{std::mt19937_64(6)};
  const System general(Matrix::Identity(5, 5), s.skew(5), s.symmetric(5, 0));
  EXPECT_EQ(to_string(realify(general.impedance(1.3), analyse(general)).how), "tridiagonal");
}
