// First-order systems against singular values.
#include "support/random_matrices.h"
#include "gyromode/base/rounding.h"
#include "gyromode/dense/solve.h"
#include "gyromode/lapack/small.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gyromode::dense {
namespace {

using support::Source;

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
      const lapack::SymmetricEigen e = small::symmetric_eigen(inertia);
      const Matrix root = e.vectors * e.values.cwiseSqrt().cwiseInverse().asDiagonal() * e.vectors.transpose();
      const Vector twin = small::singular_values((root * g * root).cast<Complex>());  // each frequency twice
      ASSERT_EQ(2 * static_cast<Index>(found.size()) + zeros, n);
      for (Index i = 0; i < n; ++i) {
        const double expected = i / 2 < static_cast<Index>(found.size()) ? found[static_cast<std::size_t>(i / 2)] : 0;
        EXPECT_NEAR(twin(i), expected, 10 * static_cast<double>(n) * epsilon * (twin(0) + 1)) << "n = " << n << ", blocks " << blocks;
      }
    }
  }
}

}  // namespace
}  // namespace gyromode::dense
