// Parseval's identity passes the roots of regular systems, and no list in which a root stands twice and another is
// missing.
#include "gyromode/certificate/measure.h"
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
  if (quadrature) support::make_quadrature(m, g, k);
  return System(m, g, k);
}

struct Solved {
  dense::Impedance h;
  Spectrum s;
};

Solved solved(const System& system) {
  const Component c = analyse(system).components.front();
  dense::Impedance h = dense::impedance_of(system, c, Method::automatic);
  Spectrum s = dense::solve(h, c, Method::automatic);
  return {std::move(h), std::move(s)};
}

void list_twice(Spectrum& s, Index listed, Index missing) {
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
        EXPECT_TRUE(no_root_twice(x.h, x.s, products(x.h, x.s))) << n << " " << quadrature << " " << spin;
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
          Spectrum s = x.s;
          list_twice(s, listed, missing);
          EXPECT_FALSE(no_root_twice(x.h, s, products(x.h, s))) << n << " " << quadrature << " " << listed << " for " << missing;
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
  EXPECT_TRUE(no_root_twice(x.h, x.s, products(x.h, x.s)));
  for (const double angle : {0.0, 1e-3, 0.3}) {
    Spectrum s = x.s;
    s.re.col(1) = std::cos(angle) * s.re.col(0) + std::sin(angle) * x.s.re.col(1);
    s.im.col(1) = std::cos(angle) * s.im.col(0) + std::sin(angle) * x.s.im.col(1);
    EXPECT_FALSE(no_root_twice(x.h, s, products(x.h, s))) << angle;
  }
}

// Stabilised, divergent and fluttering systems: shares of both signs, and roots off the axis.
TEST(Parseval, IndefiniteSystems) {
  Source source{std::mt19937_64(19)};
  int unstable = 0;
  for (const Index n : {4, 7, 12, 70}) {
    for (const Index negative : {Index{1}, Index{2}, n / 2}) {
      for (const double spin : {0.3, 3.0, 30.0}) {
        const Solved x = solved(System(source.symmetric(n, 0), spin * source.skew(n), source.symmetric(n, negative)));
        EXPECT_TRUE(no_root_twice(x.h, x.s, products(x.h, x.s))) << n << " " << negative << " " << spin;
        unstable += x.s.unstable.count() > 0;
        if (n > 12) continue;
        for (Index listed = 0; listed < x.s.omega.size(); ++listed) {
          Spectrum s = x.s;
          const Index missing = (listed + 1) % s.omega.size();
          if (missing == listed) continue;
          list_twice(s, listed, missing);
          EXPECT_FALSE(no_root_twice(x.h, s, products(x.h, s))) << n << " " << negative << " " << spin;
        }
        for (Index listed = 0; listed + 1 < x.s.unstable.count(); ++listed) {
          Spectrum s = x.s;
          if ((s.unstable.lambda[static_cast<std::size_t>(listed)].imag() == 0) !=
              (s.unstable.lambda[static_cast<std::size_t>(listed) + 1].imag() == 0))
            continue;
          s.unstable.lambda[static_cast<std::size_t>(listed)] = s.unstable.lambda[static_cast<std::size_t>(listed) + 1];
          s.unstable.right.col(listed) = s.unstable.right.col(listed + 1);
          s.unstable.left.col(listed) = s.unstable.left.col(listed + 1);
          EXPECT_FALSE(no_root_twice(x.h, s, products(x.h, s))) << n << " " << negative << " " << spin;
        }
      }
    }
  }
  EXPECT_GT(unstable, 12);
}

TEST(Parseval, SaysNothingWhereItDoesNotHold) {
  Source source{std::mt19937_64(17)};
  Solved short_of_one = solved(System(source.symmetric(6, 0), source.skew(6), source.symmetric(6, 0)));
  short_of_one.s.omega.conservativeResize(5);
  short_of_one.s.re.conservativeResize(6, 5);
  short_of_one.s.im.conservativeResize(6, 5);
  EXPECT_FALSE(no_root_twice(short_of_one.h, short_of_one.s, products(short_of_one.h, short_of_one.s)));
  Matrix k = Matrix::Zero(4, 4);
  k.topLeftCorner(3, 3) = source.symmetric(3, 0);
  const Solved singular = solved(System(Matrix::Identity(4, 4), source.skew(4), k));
  EXPECT_FALSE(no_root_twice(singular.h, singular.s, products(singular.h, singular.s)));
}

}  // namespace
}  // namespace gyromode
