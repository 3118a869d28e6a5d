// Flutter shapes belong to the root that they stand beside: (K + λG + λ²M) X = 0 for λ = σ + jω, by every solver that
// finds flutter, and through the removal of zero roots.
#include "gyromode/dense/solve.h"
#include "gyromode/lapack/small.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace gyromode::dense {
namespace {

Matrix gaussian(Index rows, Index cols, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Matrix a(rows, cols);
  for (double& x : a.reshaped()) x = normal(random);
  return a;
}

// K of both signs in both groups, so that the partition goes to P; `zeros` coordinates of the first group without
// stiffness.
System unstable_system(Index p, Index r, Index zeros, std::mt19937_64& random) {
  const Index n = p + r;
  Matrix m = Matrix::Identity(n, n);
  Matrix k = Matrix::Zero(n, n);
  Matrix g = Matrix::Zero(n, n);
  for (const auto& [at, size, free] : {std::tuple{Index{0}, p, zeros}, std::tuple{p, r, Index{0}}}) {
    const Matrix a = gaussian(size, size, random);
    m.block(at, at, size, size) += 0.1 * a * a.transpose() / static_cast<double>(size);
    const Matrix b = gaussian(size - free, size - free, random);
    k.block(at + free, at + free, size - free, size - free) = b + b.transpose();
  }
  g.topRightCorner(p, r) = gaussian(p, r, random);
  g.bottomLeftCorner(r, p) = -g.topRightCorner(p, r).transpose();
  return System(symmetric_part(m), g, k);
}

double residual(const System& s, const Spectrum& spectrum, Index k) {
  const auto& order = spectrum.order;
  const Complex lambda = spectrum.unstable.lambda[static_cast<std::size_t>(k)];
  const auto taken = [&](const Matrix& a) { return ComplexMatrix(restricted(a, order, order).cast<Complex>()); };
  const ComplexMatrix n = taken(s.stiffness()) + lambda * taken(s.gyroscopic()) + lambda * lambda * taken(s.mass());
  const ComplexVector x = spectrum.unstable.right.col(k);
  return (n * x).norm() / (n.norm() * x.norm());
}

class FlutterShapes : public testing::TestWithParam<std::tuple<Method, Index>> {};

TEST_P(FlutterShapes, AnnihilateTheCharacteristicMatrix) {
  const auto [method, zeros] = GetParam();
  std::mt19937_64 random(17);
  Index seen = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const System s = unstable_system(4, 5, zeros, random);
    for (const Component& component : analyse(s).components) {
      const Spectrum spectrum = solve(s, component, method);
      ASSERT_EQ(spectrum.unstable.right.cols(), spectrum.unstable.count());
      for (Index k = 0; k < spectrum.unstable.count(); ++k) {
        ++seen;
        EXPECT_LE(residual(s, spectrum, k), 1e4 * 9 * std::numeric_limits<double>::epsilon()) << "trial " << trial;
      }
    }
  }
  EXPECT_GT(seen, 20);
}

// Exact copies in coordinates that hide them: roots that coincide to the last bit have as many left as right vectors.
TEST(UnstableShapes, CopiesHaveLeftVectorsOfTheirOwn) {
  std::mt19937_64 random(29);
  Index seen = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Index own = 6, n = 2 * own;
    const Matrix a = gaussian(own, own, random), b = gaussian(own, own, random);
    const Matrix t = small::orthogonal_factor(gaussian(n, n, random));
    const auto twice = [&](const Matrix& one) {
      Matrix two = Matrix::Zero(n, n);
      two.topLeftCorner(own, own) = two.bottomRightCorner(own, own) = one;
      return Matrix(t * two * t.transpose());
    };
    const System s(Matrix::Identity(n, n), skew_part(twice(a - a.transpose())), symmetric_part(twice(b + b.transpose())));
    for (const Component& component : analyse(s).components) {
      const Spectrum spectrum = solve(s, component, Method::general);
      const auto& roots = spectrum.unstable;
      for (Index i = 0; i < roots.count(); ++i) {
        for (Index k = i + 1; k < roots.count(); ++k) {
          if (std::abs(roots.lambda[static_cast<std::size_t>(i)] - roots.lambda[static_cast<std::size_t>(k)]) > 1e-9) continue;
          ++seen;
          ComplexMatrix left(n, 2);
          left << roots.left.col(i).normalized(), roots.left.col(k).normalized();
          EXPECT_GT(small::singular_values(left)(1), 1e-3) << "trial " << trial << ", roots " << roots.lambda[static_cast<std::size_t>(i)]
                                                           << " and " << roots.lambda[static_cast<std::size_t>(k)];
        }
      }
    }
  }
  EXPECT_GT(seen, 60);
}

INSTANTIATE_TEST_SUITE_P(All, FlutterShapes,
                         testing::Combine(testing::Values(Method::automatic, Method::general, Method::companion),
                                          testing::Values(Index{0}, Index{1})));

}  // namespace
}  // namespace gyromode::dense
