// Refinement brings a perturbed root back, and to no other.
#include "support/random_matrices.h"
#include "gyromode/base/rounding.h"
#include "gyromode/refinement/correct.h"
#include "gyromode/dense/refinement/refine.h"
#include "gyromode/dense/solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gyromode::dense {
namespace {

using support::Source;

System refinable(Source& source, Index n, bool quadrature, Index negative) {
  Matrix m = source.symmetric(n, 0), k = source.symmetric(n, negative), g = 2 * source.skew(n);
  if (quadrature) support::make_quadrature(m, g, k);
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
      const dense::Impedance h(system, s);
      correct(h, s);
      const Spectrum exact = s;
      for (Index i = 0; i < s.omega.size(); ++i) {
        const double gap = gap_of(exact, i);
        if (gap < 1e-2 * exact.omega(i)) continue;
        perturb(source, s, i, 1e-4 * gap, 1e-5);
        EXPECT_TRUE(refine(h, s, {i}, 0.3 * gap)) << "draw " << draw;
        const Assessment a = measure(h, s);
        EXPECT_LE(a.residual(i), 10 * static_cast<double>(n) * epsilon) << "draw " << draw << ", root " << i;
        EXPECT_LE(std::abs(s.omega(i) - exact.omega(i)), 10 * static_cast<double>(n) * epsilon * a.sensitivity(i))
            << "draw " << draw << ", root " << i;
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
      const dense::Impedance h(system, s);
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

}  // namespace
}  // namespace gyromode::dense
