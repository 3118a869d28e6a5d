// Islands of instability by divergence between the points of a grid, however narrow: K₀ + Ω²K₂ tells where they are.
#include "gyromode/models/model.h"
#include "support/random_matrices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>

namespace gyromode {
namespace {

// Blocks of unequal stiffness in turning axes, unstable where ω₁ < Ω < ω₂ (published case B2), mixed by an orthogonal
// transformation.
struct Islands {
  SpinFamily family;
  std::vector<double> ends;
};

Islands islands(support::Source& source, double range) {
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(source.bits); };
  const Index blocks = source.integer(1, 3), n = 2 * blocks;
  Matrix g = Matrix::Zero(n, n), k = g;
  Islands all;
  for (Index b = 0; b < blocks; ++b) {
    const double w1 = uniform(0.05, 0.9) * range, w2 = w1 + range * std::pow(10, uniform(-9, -2));
    k(2 * b, 2 * b) = w1 * w1;
    k(2 * b + 1, 2 * b + 1) = w2 * w2;
    g(2 * b, 2 * b + 1) = -2;
    g(2 * b + 1, 2 * b) = 2;
    all.ends.insert(all.ends.end(), {w1, w2});
  }
  const Matrix q = source.integer(0, 1) == 0 ? Matrix(Matrix::Identity(n, n)) : source.orthogonal(n);
  const auto turned = [&](const Matrix& a, double sign) {
    return Matrix(0.5 * (q.transpose() * a * q + sign * (q.transpose() * a * q).transpose()));
  };
  all.family = {
      turned(Matrix::Identity(n, n), 1), Matrix::Zero(n, n), turned(g, -1), turned(k, 1), turned(-Matrix::Identity(n, n), 1), {}, {}};
  std::sort(all.ends.begin(), all.ends.end());
  return all;
}

TEST(DivergenceIslands, EveryOneIsInTheMap) {
  const char* count = std::getenv("GYROMODE_ISLANDS");
  const int draws = count ? std::atoi(count) : 100;
  support::Source source{std::mt19937_64(31)};
  int found = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const double range = std::pow(10, static_cast<double>(source.integer(-3, 4)));
    const Islands known = islands(source, range);
    std::vector<double> spins;
    for (int k = 0; k < 8; ++k) spins.push_back(range * k / 7);
    const StabilityMap map = Model(known.family, 0.0).stability_over({{"spin", spins}});
    for (std::size_t k = 0; k < known.ends.size(); ++k) {
      const bool apart = (k == 0 || known.ends[k] - known.ends[k - 1] > 1e-9 * range) &&
                         (k + 1 == known.ends.size() || known.ends[k + 1] - known.ends[k] > 1e-9 * range);
      if (!apart) continue;
      const double nearest = std::accumulate(map.critical.begin(), map.critical.end(), 1e300, [&](double least, const CriticalValue& c) {
        return std::min(least, std::abs(c.value - known.ends[k]));
      });
      EXPECT_LE(nearest, 1e-11 * range) << draw << ": " << known.ends[k] / range;
      ++found;
    }
  }
  std::printf("%d ends of islands\n", found);
}

}  // namespace
}  // namespace gyromode
