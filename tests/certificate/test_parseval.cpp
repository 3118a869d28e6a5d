// Parseval's identity passes the modes of definite systems, and no list in which a mode stands twice and another is missing.
#include "gyromode/certificate/assess.h"
#include "gyromode/certificate/parseval.h"
#include "gyromode/dense/solve.h"
#include "support/random_matrices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gyromode {
namespace {

using support::Source;

System definite(Source& source, Index n, bool quadrature, double spin) {
  Matrix m = source.symmetric(n, 0), k = source.symmetric(n, 0), g = spin * source.skew(n);
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

struct Solved {
  Impedance h;
  dense::Spectrum s;
};

Solved solved(const System& system) {
  const Component c = analyse(system).components.front();
  Impedance h = dense::impedance_of(system, c, dense::Method::automatic);
  dense::Spectrum s = dense::solve(h, c, dense::Method::automatic);
  return {std::move(h), std::move(s)};
}

void list_twice(dense::Spectrum& s, Index listed, Index missing) {
  s.omega(missing) = s.omega(listed);
  s.re.col(missing) = s.re.col(listed);
  s.im.col(missing) = s.im.col(listed);
}

TEST(Parseval, EveryModeOnce) {
  Source source{std::mt19937_64(7)};
  for (const Index n : {2, 3, 8, 25, 80}) {
    for (const bool quadrature : {false, true}) {
      for (const double spin : {0.1, 1.0, 100.0}) {
        const Solved x = solved(definite(source, n, quadrature, spin));
        EXPECT_TRUE(no_mode_twice(x.h, x.s, products(x.h, x.s))) << n << " " << quadrature << " " << spin;
      }
    }
  }
}

TEST(Parseval, AModeInThePlaceOfAnother) {
  Source source{std::mt19937_64(11)};
  for (const Index n : {2, 5, 12}) {
    for (const bool quadrature : {false, true}) {
      const Solved x = solved(definite(source, n, quadrature, 1));
      for (Index listed = 0; listed < n; ++listed) {
        for (Index missing = 0; missing < n; ++missing) {
          if (missing == listed) continue;
          dense::Spectrum s = x.s;
          list_twice(s, listed, missing);
          EXPECT_FALSE(no_mode_twice(x.h, s, products(x.h, s))) << n << " " << quadrature << " " << listed << " for " << missing;
        }
      }
    }
  }
}

// Two shapes of a double mode that are not independent: X₁ and a combination of X₁ and X₂ near it.
TEST(Parseval, ShapesOfADoubleModeThatPointTheSameWay) {
  Source source{std::mt19937_64(13)};
  const Matrix m = source.symmetric(6, 0), k = source.symmetric(6, 0), g = source.skew(6);
  Matrix zero = Matrix::Zero(6, 6);
  Matrix two_m(12, 12), two_g(12, 12), two_k(12, 12);
  const auto twice = [&](const Matrix& a, Matrix& b) { b << a, zero, zero, a; };
  twice(m, two_m);
  twice(g, two_g);
  twice(k, two_k);
  const Matrix q = source.orthogonal(12);
  const Solved x = solved(System(q.transpose() * two_m * q, q.transpose() * two_g * q, q.transpose() * two_k * q));
  ASSERT_EQ(x.s.omega.size(), 12);
  EXPECT_TRUE(no_mode_twice(x.h, x.s, products(x.h, x.s)));
  for (const double angle : {0.0, 1e-3, 0.3}) {
    dense::Spectrum s = x.s;
    s.re.col(1) = std::cos(angle) * s.re.col(0) + std::sin(angle) * x.s.re.col(1);
    s.im.col(1) = std::cos(angle) * s.im.col(0) + std::sin(angle) * x.s.im.col(1);
    EXPECT_FALSE(no_mode_twice(x.h, s, products(x.h, s))) << angle;
  }
}

TEST(Parseval, SaysNothingWhereItDoesNotHold) {
  Source source{std::mt19937_64(17)};
  const Solved indefinite = solved(System(source.symmetric(6, 0), source.skew(6), source.symmetric(6, 2)));
  EXPECT_FALSE(no_mode_twice(indefinite.h, indefinite.s, products(indefinite.h, indefinite.s)));
  Matrix k = Matrix::Zero(4, 4);
  k.topLeftCorner(3, 3) = source.symmetric(3, 0);
  const Solved singular = solved(System(Matrix::Identity(4, 4), source.skew(4), k));
  EXPECT_FALSE(no_mode_twice(singular.h, singular.s, products(singular.h, singular.s)));
}

}  // namespace
}  // namespace gyromode
