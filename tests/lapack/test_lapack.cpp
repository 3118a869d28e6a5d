// The wrappers of BLAS and LAPACK against slow twins in Eigen and against matrices made from known factors. Operands
// are views of blocks in frames of NaN: whatever a wrapper reads beside its operand turns the result into NaN, whatever
// it writes there shows in the frame.

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/general.h"
#include "gyromode/lapack/indefinite.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/singular.h"
#include "gyromode/lapack/small.h"
#include "gyromode/lapack/status.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <new>
#include <random>
#include <string>

namespace gyromode::lapack {
namespace {

using Random = std::mt19937_64;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::initializer_list<Index> orders = {0, 1, 2, 3, 7, 40, 130};

double real(Index n) { return static_cast<double>(n); }

Matrix random_matrix(Index rows, Index cols, Random& random) {
  std::normal_distribution<double> normal;
  return Matrix::NullaryExpr(rows, cols, [&] { return normal(random); });
}

ComplexMatrix random_complex(Index rows, Index cols, Random& random) {
  ComplexMatrix a(rows, cols);
  a.real() = random_matrix(rows, cols, random);
  a.imag() = random_matrix(rows, cols, random);
  return a;
}

Matrix random_symmetric(Index n, Random& random) {
  const Matrix a = random_matrix(n, n, random);
  return a + a.transpose();
}

// Lower triangle of a, NaN above: what a wrapper that reads the lower triangle may be given.
Matrix lower_only(Matrix a) {
  for (Index j = 1; j < a.cols(); ++j) a.col(j).head(j).setConstant(nan);
  return a;
}

// A lower triangle whose inverse is tame.
Matrix random_lower(Index n, Random& random) {
  Matrix l = random_matrix(n, n, random).triangularView<Eigen::StrictlyLower>();
  l /= std::max(1.0, std::sqrt(real(n)));
  l.diagonal() = (2 + random_matrix(n, 1, random).array().tanh()).matrix();
  return l;
}

struct Framed {
  Matrix frame;
  Index rows, cols;
  explicit Framed(const Matrix& a) : frame(Matrix::Constant(a.rows() + 5, a.cols() + 3, nan)), rows(a.rows()), cols(a.cols()) {
    view() = a;
  }
  Eigen::Block<Matrix> view() { return frame.block(2, 1, rows, cols); }
  bool intact() const { return frame.array().isNaN().count() == frame.size() - rows * cols; }
};

// |found − expected| ≤ 4(k + 2)ε·bound entrywise; k is the length of the sums, bound what the absolute values add up
// to.
void expect_entries(const Matrix& found, const Matrix& expected, const Matrix& bound, Index k, const std::string& what) {
  ASSERT_EQ(found.rows(), expected.rows()) << what;
  ASSERT_EQ(found.cols(), expected.cols()) << what;
  EXPECT_TRUE(((found - expected).array().abs() <= 4 * real(k + 2) * epsilon * bound.array()).all()) << what;
}

template <class A>
void expect_small(const A& a, double bound, const std::string& what) {
  const double norm = a.norm();
  EXPECT_TRUE(norm <= bound) << what << ": " << norm << " > " << bound;  // NaN fails
}

template <class A>
void expect_orthonormal(const A& q, const std::string& what) {
  const Index n = q.cols();
  expect_small((q.adjoint() * q - A::Identity(n, n)).eval(), 20 * real(n + 1) * epsilon, what + " orthonormal");
}

TEST(Multiply, EveryProductOfEveryShape) {
  Random random(1);
  for (const Index m : {0, 1, 2, 7, 40}) {
    for (const Index k : {0, 1, 3, 40}) {
      for (const Index n : {0, 1, 2, 35}) {
        const std::string shape = std::to_string(m) + " × " + std::to_string(k) + " × " + std::to_string(n);
        const Matrix a = random_matrix(m, k, random), b = random_matrix(k, n, random), c = random_matrix(m, n, random);
        const Matrix ab = a.lazyProduct(b), bound = a.cwiseAbs().lazyProduct(b.cwiseAbs());
        Framed fa(a), fb(b), at(a.transpose()), bt(b.transpose()), fc(c);
        expect_entries(multiply(fa.view(), fb.view()), ab, bound, k, "A B " + shape);
        expect_entries(multiply_tn(at.view(), fb.view()), ab, bound, k, "Aᵀ B " + shape);
        expect_entries(multiply_nt(fa.view(), bt.view()), ab, bound, k, "A Bᵀ " + shape);
        multiply_into(fc.view(), -2, at.view(), true, bt.view(), true, 0.5);
        expect_entries(fc.view(), 0.5 * c - 2 * ab, 2 * bound + c.cwiseAbs(), k, "0.5 C − 2 AᵀᵀBᵀᵀ " + shape);
        EXPECT_TRUE(fc.intact()) << shape;
        expect_entries(gram(fa.view()), a.transpose().lazyProduct(a), a.cwiseAbs().transpose().lazyProduct(a.cwiseAbs()), m,
                       "AᵀA " + shape);
      }
    }
  }
}

TEST(Multiply, RowsAndColumnsAreViewsToo) {
  Random random(2);
  const Matrix a = random_matrix(5, 4, random), b = random_matrix(4, 6, random);
  expect_entries(multiply(a.row(3), b), a.row(3) * b, a.row(3).cwiseAbs() * b.cwiseAbs(), 4, "a row");
  expect_entries(multiply(a, b.col(2)), a * b.col(2), a.cwiseAbs() * b.col(2).cwiseAbs(), 4, "a column");
  expect_entries(multiply_tn(a.transpose(), b), a * b, a.cwiseAbs() * b.cwiseAbs(), 4, "a transposed expression");
}

TEST(Multiply, BetaZeroOverwritesWithEmptyInnerDimension) {  // c *= 0 keeps NaN; BLAS with β = 0 does not read C
  Matrix c = Matrix::Constant(2, 2, nan);
  multiply_into(c, 1, Matrix(2, 0), false, Matrix(0, 2), false, 0);
  EXPECT_TRUE(c == Matrix::Zero(2, 2));
}

TEST(Multiply, MirrorsTheLowerTriangleInPlace) {
  Random random(3);
  for (const Index n : orders) {
    const Matrix s = random_symmetric(n, random);
    Framed f(lower_only(s));
    mirror_lower(f.view());
    EXPECT_TRUE(f.view() == s) << n;
    EXPECT_TRUE(f.intact()) << n;
  }
}

TEST(Triangular, SolvesAndMultiplies) {
  Random random(4);
  for (const Index n : orders) {
    for (const Index m : {0, 1, 6}) {
      const Matrix l = random_lower(n, random), b = random_matrix(n, m, random), c = b.transpose(), size = l.cwiseAbs();
      Framed fl(lower_only(l)), x(b), xt(b), xr(c), y(b), yr(c);
      solve_lower(fl.view(), x.view());
      solve_lower_transposed(fl.view(), xt.view());
      solve_lower_transposed_right(fl.view(), xr.view());
      multiply_lower_transposed(fl.view(), y.view());
      multiply_lower_right(fl.view(), yr.view());
      // residuals of substitution are small entry by entry (Higham 2002, Thm 8.5)
      const std::string at = std::to_string(n) + ", " + std::to_string(m);
      expect_entries(l.lazyProduct(x.view()), b, size.lazyProduct(x.view().cwiseAbs()), n, "L⁻¹ b " + at);
      expect_entries(l.transpose().lazyProduct(xt.view()), b, size.transpose().lazyProduct(xt.view().cwiseAbs()), n, "L⁻ᵀ b " + at);
      expect_entries(xr.view().lazyProduct(l.transpose()), c, xr.view().cwiseAbs().lazyProduct(size.transpose()), n, "c L⁻ᵀ " + at);
      expect_entries(y.view(), l.transpose().lazyProduct(b), size.transpose().lazyProduct(b.cwiseAbs()), n, "Lᵀ b " + at);
      expect_entries(yr.view(), c.lazyProduct(l), c.cwiseAbs().lazyProduct(size), n, "c L " + at);
      EXPECT_TRUE(x.intact() && xt.intact() && xr.intact() && y.intact() && yr.intact()) << at;
    }
    const Matrix l = random_lower(n, random), a = random_symmetric(n, random), k = congruence(l, l * a * l.transpose());
    EXPECT_TRUE(k == k.transpose()) << n;
    const Matrix gram = gram_of_lower(l).triangularView<Eigen::Lower>();
    expect_small(Matrix(gram - Matrix(Matrix(l.transpose() * l).triangularView<Eigen::Lower>())),
                 10 * real(n + 1) * epsilon * l.squaredNorm(), "LᵀL");
    expect_small(Matrix(k - a), 100 * real(n + 1) * epsilon * (1 + l.norm() * small::inverse(l).norm() * a.norm()), "L⁻¹ L A Lᵀ L⁻ᵀ = A");
  }
}

// A = L D Lᵀ in integers, L unit lower, D = 1 or 4 but for one pivot ≤ 0: the factorisation is exact, the position
// known.
TEST(Triangular, CholeskyFindsTheFactorOrTheFirstBadPivot) {
  Random random(5);
  std::uniform_int_distribution<int> bit(0, 1);
  for (const Index n : orders) {
    Matrix l = Matrix::Identity(n, n), root = Matrix::Identity(n, n);
    for (Index j = 0; j < n; ++j) {
      for (Index i = j + 1; i < n; ++i) l(i, j) = bit(random);
      root(j, j) = 1 + bit(random);
    }
    const Matrix factor = l * root, a = factor * factor.transpose();
    Framed good(lower_only(a));
    EXPECT_EQ(cholesky(good.view()), std::nullopt) << n;
    EXPECT_TRUE(good.view() == factor) << n;
    EXPECT_TRUE(good.intact()) << n;
    for (Index k = 0; k < n; k += 1 + n / 5) {
      for (const double pivot : {0.0, -1.0}) {
        Matrix d = root * root;
        d(k, k) = pivot;
        Framed bad(lower_only(l * d * l.transpose()));
        EXPECT_EQ(cholesky(bad.view()), std::optional<Index>(k)) << "order " << n << " pivot " << pivot;
      }
    }
  }
}

TEST(Triangular, CholeskyRefusesNaN) {  // OpenBLAS tests the pivot with ≤ 0, which NaN passes
  Matrix a = Matrix::Identity(2, 2);
  a(1, 0) = nan;
  EXPECT_NE(cholesky(a), std::nullopt);
}

TEST(Triangular, ConditionIsNotOverestimatedNorMuchUnder) {
  Random random(6);
  for (const Index n : {1, 2, 7, 40}) {
    const Matrix l = random_lower(n, random), a = l * l.transpose(), s = random_symmetric(n, random);
    const auto norm = [](const Matrix& x) { return x.cwiseAbs().colwise().sum().maxCoeff(); };
    const double definite = 1 / (norm(a) * norm(small::inverse(a))), indefinite = 1 / (norm(s) * norm(small::inverse(s)));
    const double found[] = {reciprocal_condition(lower_only(l), norm(a)) / definite,
                            reciprocal_condition(factor_indefinite(s), norm(s)) / indefinite};
    for (const double ratio : found) EXPECT_TRUE(ratio >= 1 - 1e-8 && ratio <= 3) << n << ": " << ratio;
  }
  EXPECT_EQ(reciprocal_condition(Matrix(0, 0), 0), 1);
  EXPECT_EQ(reciprocal_condition(factor_indefinite(Matrix(Matrix::Zero(3, 3))), 1), 0);
}

TEST(Triangular, CompletionStartsWithTheSpan) {
  Random random(7);
  for (const Index n : orders) {
    for (const Index r : {Index{0}, std::min<Index>(1, n), n / 2, n}) {
      const Matrix a = random_matrix(n, r, random);
      Framed f(a);
      const Matrix q = orthogonal_completion(f.view());
      ASSERT_EQ(q.rows(), n);
      ASSERT_EQ(q.cols(), n);
      expect_orthonormal(q, "completion");
      expect_small(Matrix(q.rightCols(n - r).transpose() * a), 20 * real(n + 1) * epsilon * a.norm(),
                   "what is left of A outside the first columns");
    }
  }
}

TEST(Symmetric, EigenvaluesAndVectors) {
  Random random(8);
  for (const Index n : orders) {
    const Matrix a = random_symmetric(n, random), l = random_lower(n, random), b = l * l.transpose();
    const auto e = symmetric_eigen(lower_only(a));
    ASSERT_EQ(e.values.size(), n);
    const double unit = 20 * real(n + 1) * epsilon;
    expect_orthonormal(e.vectors, "V");
    expect_small(Matrix(a * e.vectors - e.vectors * e.values.asDiagonal()), unit * a.norm(), "A V = V Λ");
    EXPECT_TRUE(std::is_sorted(e.values.begin(), e.values.end()));
    expect_small(Vector(symmetric_eigenvalues(lower_only(a)) - e.values), unit * a.norm(), "values alone");
    const auto g = symmetric_definite_eigen(lower_only(a), lower_only(b));
    EXPECT_TRUE(std::is_sorted(g.values.begin(), g.values.end()));
    if (n == 0) continue;
    expect_small(Vector(e.values - small::symmetric_eigenvalues(a)), unit * a.norm(), "twin");
    const double condition = b.norm() * small::inverse(b).norm();
    expect_small(Matrix(g.vectors.transpose() * b * g.vectors - Matrix::Identity(n, n)), unit * condition, "VᵀBV = 1");
    expect_small(Matrix(a * g.vectors - b * g.vectors * g.values.asDiagonal()), unit * condition * a.norm() * g.vectors.norm(),
                 "A V = B V Λ");
  }
}

// A = U Λ Uᴴ is normal, so the values are as well conditioned as can be.
TEST(General, ValuesAndVectorsOfNormalMatrices) {
  Random random(9);
  for (const Index n : orders) {
    Matrix d = Matrix::Zero(n, n);
    ComplexVector truth(n);
    for (Index k = 0; k < n; ++k) truth(k) = d(k, k) = real(k - 2);  // a zero among them
    for (Index k = 1; k + 1 < n; k += 3) {                           // pairs −k ± j(k + ½)
      d.block(k, k, 2, 2) << -real(k), real(k) + 0.5, -real(k) - 0.5, -real(k);
      truth(k) = Complex(-real(k), real(k) + 0.5);
      truth(k + 1) = std::conj(truth(k));
    }
    const Matrix q = orthogonal_completion(random_matrix(n, n, random)), a = q * d * q.transpose();
    const ComplexMatrix z = random_complex(n, n, random), u = n == 0 ? z : small::qr(z).q;
    const ComplexVector turned = truth * std::polar(1.0, 0.3);  // no conjugate pairs left
    const ComplexMatrix c = u * turned.asDiagonal() * u.adjoint();
    const auto check = [&](const GeneralEigen& e, const ComplexMatrix& m, const ComplexVector& expected) {
      ASSERT_EQ(e.values.size(), n);
      const double unit = 100 * real(n + 1) * epsilon * (1 + m.norm());
      expect_small(ComplexMatrix(m * e.vectors - e.vectors * e.values.asDiagonal()), unit, "A V = V Λ");
      for (Index k = 0; k < n; ++k) {
        EXPECT_NEAR(e.vectors.col(k).norm(), 1, 1e-14);
        EXPECT_LE((e.values.array() - expected(k)).abs().minCoeff(), unit) << "nothing near " << expected(k);
      }
    };
    const auto e = general_eigen(a);
    check(e, a.cast<Complex>(), truth);
    check(general_eigen(c), c, turned);
    EXPECT_EQ((e.values.array().imag() == 0).count(), (truth.array().imag() == 0).count());
    for (Index k = 0; k < n; ++k) {
      if (e.values(k).imag() == 0) continue;
      ASSERT_LT(k + 1, n);
      EXPECT_GT(e.values(k).imag(), 0);
      EXPECT_EQ(e.values(k + 1), std::conj(e.values(k)));
      EXPECT_TRUE(e.vectors.col(k + 1) == e.vectors.col(k).conjugate());
      ++k;
    }
  }
}

void expect_svd(const Matrix& a, const SingularValues& s, const std::string& what) {
  const Index r = std::min(a.rows(), a.cols());
  const double unit = 20 * real(a.rows() + a.cols() + 1) * epsilon;
  ASSERT_EQ(s.values.size(), r) << what;
  ASSERT_EQ(s.u.rows(), a.rows()) << what;
  ASSERT_EQ(s.vt.cols(), a.cols()) << what;
  expect_orthonormal(s.u, what + " U");
  expect_orthonormal(s.vt.transpose(), what + " V");
  expect_small(Matrix(a - s.u * s.values.asDiagonal() * s.vt), unit * a.norm(), what + " A = U Σ Vᵀ");
  EXPECT_TRUE(std::is_sorted(s.values.begin(), s.values.end(), std::greater<>())) << what;
  EXPECT_TRUE((s.values.array() >= 0).all()) << what;
  if (r > 0) expect_small(Vector(s.values - small::singular_values(a.cast<Complex>())), unit * a.norm(), what + " twin");
}

TEST(Singular, RectangularAndBidiagonal) {
  Random random(10);
  for (const Index m : {0, 1, 3, 40}) {
    for (const Index n : {0, 1, 4, 25}) {
      const Matrix a = random_matrix(m, n, random);
      expect_svd(a, singular_value_decomposition(a), std::to_string(m) + " × " + std::to_string(n));
    }
  }
  for (const Index n : {0, 1, 2, 3, 30, 60}) {
    Vector d = random_matrix(n, 1, random), e = random_matrix(std::max<Index>(n - 1, 0), 1, random);
    if (n > 2) d(1) = e(0) = 0;
    Matrix b = d.asDiagonal();
    if (n > 1) b.diagonal(1) = e;
    expect_svd(b, bidiagonal_svd(d, e), "bidiagonal " + std::to_string(n));
  }
  EXPECT_EQ(bidiagonal_svd(Vector::Constant(1, -3), Vector(0)).values(0), 3);
}

TEST(Indefinite, SolvesRealAndHermitian) {
  Random random(11);
  for (const Index n : orders) {
    for (const Index m : {0, 1, 5}) {
      const Matrix a = random_symmetric(n, random), b = random_matrix(n, m, random), x = solve(factor_indefinite(lower_only(a)), b);
      expect_small(Matrix(a * x - b), 20 * real(n + 1) * epsilon * a.norm() * x.norm(), "A x = b");
      const ComplexMatrix z = random_complex(n, n, random), h = z + z.adjoint(), c = random_complex(n, m, random),
                          y = solve(factor_indefinite(h), c);
      expect_small(ComplexMatrix(h * y - c), 20 * real(n + 1) * epsilon * h.norm() * y.norm(), "H y = c");
    }
  }
}

// Pivots of both signs: truth from the eigenvalues, which the construction keeps away from zero or which are looked at
// first.
template <class AnyMatrix>
void expect_inertia(const AnyMatrix& a, int& trials) {
  const Vector lambda = small::hermitian_eigenvalues(ComplexMatrix(a.template cast<Complex>()));
  if (!(lambda.cwiseAbs().minCoeff() > 1e-9 * lambda.cwiseAbs().maxCoeff())) return;
  const Vector d = pivot_values(factor_indefinite(a));
  ASSERT_EQ(d.size(), a.rows());
  EXPECT_EQ((d.array() < 0).count(), (lambda.array() < 0).count()) << a;
  EXPECT_EQ((d.array() > 0).count(), (lambda.array() > 0).count()) << a;
  ++trials;
}

TEST(Indefinite, PivotsHaveTheSignsOfTheEigenvalues) {
  Random random(12);
  int trials = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Index n = 1 + trial % 25;
    ComplexMatrix h = random_complex(n, n, random);
    h = (h + h.adjoint()).eval();
    if (n > 1) h.diagonal() *= std::initializer_list<double>{1, 1e-8, 1e-16, 0}.begin()[trial % 4];
    expect_inertia(h, trials);
    expect_inertia(Matrix(h.real()), trials);
  }
  EXPECT_GE(trials, 950);  // odd orders with a zero diagonal are not singular in general
}

TEST(Indefinite, TwoByTwoPivots) {
  for (const Index blocks : {1, 2, 9}) {  // eigenvalues ±1, each `blocks` times
    ComplexMatrix h = ComplexMatrix::Zero(2 * blocks, 2 * blocks);
    for (Index k = 0; k < blocks; ++k) {  // coupled pairs lie far from each other
      h(k, 2 * blocks - 1 - k) = Complex(0, 1);
      h(2 * blocks - 1 - k, k) = Complex(0, -1);
    }
    const Matrix a = h.cwiseAbs();
    for (Vector d : {pivot_values(factor_indefinite(a)), pivot_values(factor_indefinite(h))}) {
      std::sort(d.begin(), d.end());
      EXPECT_TRUE((d.head(blocks).array() == -1).all() && (d.tail(blocks).array() == 1).all()) << d.transpose();
    }
  }
  const Vector d = pivot_values(factor_indefinite(Matrix{{1e-20, 1}, {1, 0.5}}));  // λ² − λ/2 − 1 = 0
  EXPECT_NEAR(d(0), 0.25 + std::sqrt(1.0625), 4 * epsilon);
  EXPECT_NEAR(d(1), 0.25 - std::sqrt(1.0625), 4 * epsilon);
  const Vector e = pivot_values(factor_indefinite(Matrix{{0, 1, 0}, {1, -1e8, 1e9}, {0, 1e9, 0}}));  // first block [0 1; 1 −1e8]
  EXPECT_NEAR(e(0), -1e8, 1e8 * epsilon);
  EXPECT_NEAR(e(1), 1e-8, 1e-8 * 4 * epsilon);
  const Vector zero = pivot_values(factor_indefinite(Matrix{{1, 1}, {1, 1}}));
  EXPECT_TRUE(zero == Vector(Eigen::Vector2d(1, 0)));
  EXPECT_EQ(pivot_values(factor_indefinite(Matrix(0, 0))).size(), 0);
}

template <class Broken, class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const Broken& e) {
    return e.what();
  }
  return "(accepted)";
}

TEST(Status, DimensionsBeyond32Bits) {
  const Index top = 2147483647;
  EXPECT_EQ(dimension(0, "dgemm"), 0);
  EXPECT_EQ(dimension(top, "dgemm"), top);
  EXPECT_EQ(refusal<TooLarge>([] { dimension(top + 1, "dgemm"); }),
            "order 2147483648 is beyond what the dense dgemm takes with 32-bit workspace indices (at most 2147483647)");
  EXPECT_EQ(dimension(100, "dsyevd", 100), 100);
  EXPECT_EQ(refusal<TooLarge>([] { dimension(101, "dsyevd", 100); }),
            "order 101 is beyond what the dense dsyevd takes with 32-bit workspace indices (at most 100)");
  const Index n = largest_order(2, 6, 1);  // dsyevd: 1 + 6n + 2n²
  EXPECT_LE(1 + 6 * n + 2 * n * n, top);
  EXPECT_GT(1 + 6 * (n + 100) + 2 * (n + 100) * (n + 100), top);
}

TEST(Status, FailuresSayWhatLapackSays) {
  EXPECT_NO_THROW(require_success(0, "dsyevd", "unused"));
  EXPECT_EQ(refusal<NotConverged>([] { require_success(-5, "dsyevd", "unused"); }),
            "dsyevd: argument 5 was refused (not finite, or out of range)");
  EXPECT_EQ(refusal<NotConverged>([] { require_success(7, "dgeev", "no convergence"); }), "dgeev: no convergence (info = 7)");
  EXPECT_THROW(require_success(-1010, "dsyevd", ""), std::bad_alloc);
  EXPECT_THROW(require_success(-1011, "dsyevd", ""), std::bad_alloc);
  EXPECT_EQ(refusal<NotConverged>([] { symmetric_eigen(Matrix::Constant(2, 2, nan)); }),
            "dstedc: argument 4 was refused (not finite, or out of range)");
  EXPECT_EQ(refusal<NotConverged>([] {
              symmetric_definite_eigen(Matrix::Identity(2, 2), Matrix{{1, 2}, {2, 1}});
            }),
            "dsygvd: the right-hand matrix is not positive definite (info = 4)");
}

}  // namespace
}  // namespace gyromode::lapack
