// Counts by Sylvester's law against eigenvalues: of matrices made with known inertia, and of H(ω) of random systems in
// both classes.

#include "gyromode/base/rounding.h"
#include "gyromode/dense/impedance.h"
#include "gyromode/dense/inertia.h"
#include "gyromode/lapack/small.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace gyromode {
namespace {

using Random = std::mt19937_64;
Matrix random_matrix(Index rows, Index cols, Random& random) {
  std::normal_distribution<double> normal;
  return Matrix::NullaryExpr(rows, cols, [&] { return normal(random); });
}

Vector random_units(Index n, Random& random) {  // 12 decades
  std::uniform_real_distribution<double> exponent(-6, 6);
  return Vector::NullaryExpr(n, [&] { return std::pow(10, exponent(random)); });
}

Vector eigenvalues(const Matrix& symmetric) { return small::symmetric_eigenvalues(symmetric); }
Vector eigenvalues(const ComplexMatrix& hermitian) { return small::hermitian_eigenvalues(hermitian); }

// ---- inertia

// Orders from which a definite matrix is counted by Cholesky: definite, and all but definite with the same signs on the
// diagonal.
TEST(Inertia, DefiniteMatricesAndThoseThatAreNearlySo) {
  Random random(43);
  for (const Index n : {63, 64, 65, 120}) {
    for (const Index negative : {Index{0}, Index{1}, n - 1, n}) {
      ComplexMatrix z(n, n);
      z.real() = random_matrix(n, n, random);
      z.imag() = random_matrix(n, n, random);
      const ComplexMatrix u = small::qr(z).q;
      const Matrix q = small::orthogonal_factor(z.real());
      Vector lambda = random_matrix(n, 1, random).cwiseAbs().cwiseMin(1).array() + 1;
      lambda.head(negative) *= -1;
      for (const double last : {1.0, 1e-3, 1e-9}) {
        Vector values = lambda;
        // the only one of its sign, if there is one: the diagonal does not show it
        values(negative == 1 || negative == n ? 0 : n - 1) *= last;
        for (const Inertia& found :
             {inertia(Matrix(q * values.asDiagonal() * q.transpose())), inertia(ComplexMatrix(u * values.asDiagonal() * u.adjoint()))}) {
          EXPECT_EQ(found.negative, negative) << n << " " << last;
          EXPECT_EQ(found.positive, n - negative);
          EXPECT_FALSE(found.doubtful());
          EXPECT_LE(found.margin, last);
          EXPECT_GT(found.margin, 1e-4 * last);
        }
      }
      Vector singular = lambda.cwiseAbs();
      singular(0) = 1e-18;
      EXPECT_TRUE(inertia(Matrix(q * singular.asDiagonal() * q.transpose())).doubtful()) << n;
      EXPECT_TRUE(inertia(ComplexMatrix(-u * singular.asDiagonal() * u.adjoint())).doubtful()) << n;
    }
  }
}

// U Λ Uᴴ with 1 ≤ |λ| ≤ 2, `negative` of them below 0: condition 2. Units are then graded, which keeps the inertia.
TEST(Inertia, WellConditionedMatricesInAnyUnitsAreCountedWithoutDoubt) {
  Random random(41);
  for (int trial = 0; trial < 500; ++trial) {
    const Index n = 1 + trial % 30, negative = trial % (n + 1);
    Vector lambda = random_matrix(n, 1, random).cwiseAbs().cwiseMin(1).array() + 1;
    lambda.head(negative) *= -1;
    ComplexMatrix z(n, n);
    z.real() = random_matrix(n, n, random);
    z.imag() = random_matrix(n, n, random);
    const ComplexMatrix u = small::qr(z).q;
    const Matrix q = small::orthogonal_factor(z.real());
    const ComplexMatrix h = u * lambda.asDiagonal() * u.adjoint();
    const Matrix s = q * lambda.asDiagonal() * q.transpose();
    for (const double unit : {1e-9, 1.0, 1e9}) {
      for (const Vector& t : {Vector(Vector::Ones(n)), random_units(n, random)}) {
        const Inertia real = inertia(Matrix(unit * t.asDiagonal() * s * t.asDiagonal()));
        const Inertia complex = inertia(ComplexMatrix(unit * t.asDiagonal() * h * t.asDiagonal()));
        for (const Inertia& found : {real, complex}) {
          EXPECT_EQ(found.negative, negative) << n;
          EXPECT_EQ(found.positive, n - negative) << n;
          EXPECT_FALSE(found.doubtful()) << n << ": margin " << found.margin;
        }
      }
    }
  }
}

// [εA C; Cᵀ εB]: n₋ = n₊ = n for any nonsingular C, however small the diagonal. This is where a factorisation without 2
// × 2 pivots miscounts.
TEST(Inertia, TinyDiagonals) {
  Random random(42);
  for (int trial = 0; trial < 200; ++trial) {
    const Index n = 1 + trial % 12;
    Matrix a = Matrix::Zero(2 * n, 2 * n);
    const Matrix c = small::orthogonal_factor(random_matrix(n, n, random));
    const Matrix small = random_matrix(2 * n, 2 * n, random) * (trial % 3 == 0 ? 0 : 1e-14);
    a.topRightCorner(n, n) = c;
    a.bottomLeftCorner(n, n) = c.transpose();
    a += small + small.transpose();
    for (const Inertia& found : {inertia(a), inertia(ComplexMatrix(a.cast<Complex>()))}) {
      EXPECT_EQ(found.negative, n);
      EXPECT_EQ(found.positive, n);
      EXPECT_FALSE(found.doubtful());
    }
  }
}

// FᵀDF with F (n − 1) × n, or jS with S skew of odd order: all entries integers, singular to the last bit.
TEST(Inertia, ExactlySingularMatricesAreDoubtful) {
  Random random(43);
  std::uniform_int_distribution<int> digit(-3, 3);
  for (int trial = 0; trial < 200; ++trial) {
    const Index n = 1 + trial % 5, odd = 1 + 2 * (trial % 3);
    const auto integers = [&](Index rows, Index cols) {
      return Matrix(Matrix::NullaryExpr(rows, cols, [&] { return 1.0 * digit(random); }));
    };
    const Matrix f = integers(n - 1, n), d = integers(n - 1, 1).asDiagonal(), skew = integers(odd, odd);
    const Vector t = random_units(n, random).unaryExpr([](double x) { return std::exp2(std::round(std::log2(x))); });  // no rounding
    const Matrix k = f.transpose() * d * f;
    EXPECT_TRUE(inertia(k).doubtful()) << k << "\nmargin " << inertia(k).margin;
    EXPECT_TRUE(inertia(Matrix(t.asDiagonal() * k * t.asDiagonal())).doubtful()) << k;
    EXPECT_TRUE(inertia(ComplexMatrix(Complex(0, 1) * (skew - skew.transpose()))).doubtful()) << skew;
  }
  EXPECT_TRUE(inertia(Matrix(Matrix::Zero(3, 3))).doubtful());
  EXPECT_TRUE(inertia(Matrix{{0}}).doubtful());
}

TEST(Inertia, SmallestShapes) {
  const Inertia none = inertia(Matrix(0, 0)), one = inertia(Matrix{{-1e-300}}), swap = inertia(Matrix{{0, 1e300}, {1e300, 0}});
  EXPECT_TRUE(none.negative == 0 && none.positive == 0 && !none.doubtful());
  EXPECT_TRUE(one.negative == 1 && one.positive == 0 && !one.doubtful());
  EXPECT_TRUE(swap.negative == 1 && swap.positive == 1 && !swap.doubtful());
  EXPECT_TRUE((Inertia{1, 1, std::nan("")}).doubtful());
  EXPECT_TRUE((Inertia{1, 1, 16 * epsilon}).doubtful());  // the limit is 8 n ε
  EXPECT_FALSE((Inertia{1, 1, 17 * epsilon}).doubtful());
}

// A = L Lᵀ with L unit lower, −1 below: every pivot of A is 1, yet taking 2 ε from one entry makes an eigenvalue
// negative.
TEST(Inertia, SingularToRoundingIsDoubtfulThoughNoPivotIsSmall) {
  const Matrix l = Matrix::Identity(40, 40) - Matrix(Matrix::Ones(40, 40).triangularView<Eigen::StrictlyLower>());
  Matrix a = l * l.transpose();
  const Inertia before = inertia(a);
  a(0, 0) -= 2 * epsilon;
  const Inertia after = inertia(a);
  EXPECT_TRUE(before.negative == after.negative || before.doubtful() || after.doubtful()) << before.negative << ", " << after.negative;
}

// ---- impedance

struct Piece {
  Matrix m, g, k;
  Spectrum s;

  Matrix of(const Matrix& a) const { return a(s.order, s.order); }
};

// A component of p + r coordinates (split −1: one group of p) that sits scattered among others in a larger system, K
// indefinite, order as a solver would give it: in phase first. What couples to the rest of the system is not the
// component's and must not be seen.
Piece random_piece(Index p, Index r, bool partition, Random& random) {
  const Index n = p + r, all = n + 3;
  std::vector<Index> places(static_cast<std::size_t>(all));
  std::iota(places.begin(), places.end(), Index{0});
  std::shuffle(places.begin(), places.end(), random);
  const Matrix a = random_matrix(all, all, random), b = random_matrix(all, all, random), c = random_matrix(all, all, random);
  Piece piece{a + a.transpose() + 25 * Matrix::Identity(all, all), 2 * (b - b.transpose()), c + c.transpose(), {}};
  piece.s.order.assign(places.begin(), places.begin() + n);
  if (!partition) return piece;
  piece.s.split = p;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      const Index x = places[static_cast<std::size_t>(i)], y = places[static_cast<std::size_t>(j)];
      if ((i < p) == (j < p)) {
        piece.g(x, y) = 0;
      } else {
        piece.m(x, y) = piece.k(x, y) = 0;
      }
    }
  }
  return piece;
}

double norm_1(const Matrix& a) { return a.cwiseAbs().colwise().sum().maxCoeff(); }

// Negative eigenvalues of H(ω), complex n × n, where none is near zero.
void expect_count(const dense::Impedance& h, double omega, const ComplexMatrix& truth, int& trials) {
  const Vector lambda = eigenvalues(truth);
  if (!(lambda.cwiseAbs().minCoeff() > 1e-8 * lambda.cwiseAbs().maxCoeff())) return;
  const Inertia found = h.inertia_at(omega);
  EXPECT_EQ(found.negative, (lambda.array() < 0).count()) << "ω = " << omega;
  EXPECT_EQ(found.positive, (lambda.array() > 0).count()) << "ω = " << omega;
  EXPECT_FALSE(found.doubtful());
  ++trials;
}

TEST(Impedance, CountsAreThoseOfTheEigenvaluesOfH) {
  Random random(44);
  int trials = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const bool partition = trial % 2 == 0;
    const Piece a = random_piece(1 + trial % 7, trial % 5, partition, random);
    const System system(a.m, a.g, a.k);
    const FirstOrderSystem first(a.m, a.g);
    const dense::Impedance h(system, a.s), h1(first, a.s);
    EXPECT_TRUE(h.quadrature() == partition && h1.quadrature() == partition && h.second_order() && !h1.second_order());
    EXPECT_EQ(h.size(), a.s.size());
    for (const double omega : {0.01, 0.3, 1.0, 3.0, 30.0}) {
      expect_count(h, omega, system.impedance(omega)(a.s.order, a.s.order), trials);
      expect_count(h1, omega, first.impedance(omega)(a.s.order, a.s.order), trials);
      const double scale = norm_1(a.of(a.k)) + omega * norm_1(a.of(a.g)) + omega * omega * norm_1(a.of(a.m));
      EXPECT_NEAR(h.scale(omega), scale, 1e-14 * scale);
      EXPECT_NEAR(h1.scale(omega), omega * norm_1(a.of(a.m)) + norm_1(a.of(a.g)), 1e-14 * scale);
    }
  }
  EXPECT_GT(trials, 2900);
}

// H* = T⁻¹HT, T = diag(1, −j): real, with the spectrum of H, and so for the slopes 2ωM − jG and I. Without the
// partition the count is the same.
TEST(Impedance, RealFormHasTheSpectrumOfH) {
  Random random(45);
  for (int trial = 0; trial < 100; ++trial) {
    const Index p = 1 + trial % 6, r = trial % 4, n = p + r;
    const Piece a = random_piece(p, r, true, random);
    const System system(a.m, a.g, a.k);
    const FirstOrderSystem first(a.m, a.g);
    Spectrum whole = a.s;
    whole.split = -1;
    ComplexVector t = ComplexVector::Ones(n);
    t.tail(r).setConstant(Complex(0, -1));
    const ComplexMatrix slope_of_g = Complex(0, -1) * a.of(a.g);
    for (const double omega : {0.2, 2.0}) {
      const auto expect_real_form = [&](const dense::Impedance& h, const dense::Impedance& plain, const ComplexMatrix& truth,
                                        const ComplexMatrix& slope) {
        const double unit = epsilon * h.scale(omega);
        EXPECT_LE((plain.complex_at(omega) - truth).norm(), 4 * unit);
        EXPECT_LE((plain.complex_slope_at(omega) - slope).norm(), 4 * unit / std::min(omega, 1.0));
        EXPECT_LE((t.conjugate().asDiagonal() * truth * t.asDiagonal() - h.real_at(omega)).norm(), 4 * unit);
        EXPECT_LE((t.conjugate().asDiagonal() * slope * t.asDiagonal() - h.real_slope_at(omega)).norm(), 4 * unit / std::min(omega, 1.0));
        EXPECT_LE((eigenvalues(h.real_at(omega)) - eigenvalues(truth)).norm(), 20 * static_cast<double>(n) * unit);
        EXPECT_EQ(h.inertia_at(omega).negative, plain.inertia_at(omega).negative);
      };
      expect_real_form(dense::Impedance(system, a.s), dense::Impedance(system, whole), system.impedance(omega)(a.s.order, a.s.order),
                       2 * omega * a.of(a.m) + slope_of_g);
      expect_real_form(dense::Impedance(first, a.s), dense::Impedance(first, whole), first.impedance(omega)(a.s.order, a.s.order),
                       a.of(a.m).cast<Complex>());
    }
  }
}

}  // namespace
}  // namespace gyromode
