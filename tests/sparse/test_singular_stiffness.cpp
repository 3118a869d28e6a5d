// Sparse systems whose K is singular, by the dense engine.
#include "gyromode/modes/modes.h"
#include "sparse/as_dense.h"
#include "support/random_matrices.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace gyromode {
namespace {

// Springs between neighbours in pieces of a chain that nothing holds, or holds by the first mass; in coordinates of
// their own scale. Some springs push.
struct Chain {
  Matrix m, g, k;
  Index free = 0;  // pieces that nothing holds
};

Chain chain_of(support::Source& source, Index n, bool partition, Index pushing, Index pieces) {
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(source.bits); };
  Chain c{Matrix::Zero(n, n), Matrix::Zero(n, n), Matrix::Zero(n, n), 0};
  Vector scale(n);
  for (Index j = 0; j < n; ++j) scale(j) = std::exp2(static_cast<double>(source.integer(-2, 2)));
  for (Index j = 0; j < n; ++j) {
    c.m(j, j) = uniform(1, 2);
    for (Index i = j + 1; i < std::min(n, j + 4); ++i) {
      const bool cross = (i % 2) != (j % 2);
      if (!partition || !cross) c.m(i, j) = c.m(j, i) = uniform(-0.1, 0.1);
      if (partition && !cross) continue;
      c.g(i, j) = uniform(-1, 1);
      c.g(j, i) = -c.g(i, j);
    }
  }
  const auto spring = [&](Index i, Index j, double s) {
    c.k(i, i) += s * scale(i) * scale(i);
    c.k(j, j) += s * scale(j) * scale(j);
    c.k(i, j) -= s * scale(i) * scale(j);
    c.k(j, i) = c.k(i, j);
  };
  const Index step = partition ? 2 : 1, length = n / pieces;
  for (Index p = 0; p < pieces; ++p) {
    const Index first = p * length, end = p + 1 == pieces ? n : first + length;
    for (Index start = first; start < std::min(end, first + step); ++start) {
      for (Index i = start; i + step < end; i += step) spring(i, i + step, uniform(1, 3));
      for (Index i = start; i + 2 * step < end; i += step) spring(i, i + 2 * step, uniform(0.2, 1));
      if (source.integer(0, 3) == 0)
        c.k(start, start) += 1;
      else
        ++c.free;
    }
  }
  for (Index p = 0; p < pushing; ++p) {
    const Index i = source.integer(0, n - 1);
    c.k(i, i) -= 0.5;
  }
  return c;
}

// Blocks of K without an entry: masses that nothing holds, turned by G or not.
TEST(SingularStiffness, MayBeNothingAtAll) {
  for (const int unit : {-30, 0, 30}) {
    for (const Index n : {1, 2, 3, 6, 40}) {
      for (const double spin : {0.0, 1.0}) {
        const double s = std::exp2(unit);
        Matrix g = Matrix::Zero(n, n);
        Index turned = 0;
        for (Index i = 0; spin > 0 && i + 1 < n; i += 2, ++turned) {
          g(i, i + 1) = s * (1 + 0.1 * static_cast<double>(i));
          g(i + 1, i) = -g(i, i + 1);
        }
        ModesOptions o;
        o.window.b = 10;
        const ModesResult r = find_modes(
            SparseSystem({support::lower_of(s * Matrix::Identity(n, n)), support::lower_of(g, false), SparseMatrix(n, n), {}, {}}), o);
        EXPECT_TRUE(r.is_complete()) << n << " " << spin << ": " << r.coverage.reason;
        EXPECT_EQ(r.stability, Stability::stable) << n;
        EXPECT_EQ(r.index_balance.zero, n - turned) << n << " " << spin;
        ASSERT_EQ(static_cast<Index>(r.modes.size()), n) << n << " " << spin;
        for (Index i = 0; i < turned; ++i)
          EXPECT_NEAR(r.modes[static_cast<std::size_t>(n - turned + i)].omega, 1 + 0.2 * static_cast<double>(i), 1e-13) << n;
      }
    }
  }
}

TEST(SingularStiffness, IsAsTheDenseEngineHasIt) {
  support::Source source{std::mt19937_64(15)};
  const char* asked = std::getenv("GYROMODE_SPARSE");
  const int draws = asked ? std::atoi(asked) : 40;
  int compared = 0, singular = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const bool partition = draw % 2 == 0;
    const double unit = std::exp2(static_cast<double>(source.integer(-30, 30))),
                 time = std::exp2(static_cast<double>(source.integer(-20, 20)));
    const Chain c = chain_of(source, source.integer(24, draw % 5 == 4 ? 200 : 80), partition, draw % 3 == 2 ? source.integer(1, 2) : 0,
                             source.integer(1, 3));
    const double spin = draw % 4 == 1 ? std::exp2(static_cast<double>(source.integer(-16, 6))) : 1;
    if (!support::expect_as_dense(c.m * unit, c.g * (spin * unit / time), c.k * (unit / (time * time)), fmt::format("draw {}", draw)))
      continue;
    ++compared;
    if (c.free > 0) ++singular;
  }
  EXPECT_GT(compared, draws / 2);
  EXPECT_GT(singular, draws / 4);
}

}  // namespace
}  // namespace gyromode
