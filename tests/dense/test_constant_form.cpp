#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/dense/constant_form.h"
#include "gyromode/spectrum/spectrum.h"
#include "gyromode/lapack/small.h"
#include "gyromode/modes/modes.h"
#include "support/random_matrices.h"
#include "support/scrambled.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace gyromode;
using support::Source;

namespace {

dense::ConstantForm form_of(const System& s) { return dense::constant_form(s, analyse(s, HiddenSearch::always)); }

// Eigenvalues of W are the ω² of the modes (and −σ² of divergence), and W u = ω²u for u = (displacement + jω velocity)
// X.
void expect_form(const System& s, const char* what) {
  const dense::ConstantForm f = form_of(s);
  ASSERT_EQ(f.w.rows(), s.size());
  EXPECT_EQ((f.w - f.w.transpose()).norm(), 0);
  ModesOptions options;
  options.shapes = true;
  const ModesResult r = find_modes(s, options);
  std::vector<double> expected;
  for (const Mode& m : r.modes) expected.push_back(m.omega * m.omega);
  for (const UnstableMode& u : r.unstable) expected.push_back(-u.growth_rate * u.growth_rate);
  std::sort(expected.begin(), expected.end());
  const Vector found = small::symmetric_eigenvalues(f.w);
  ASSERT_EQ(static_cast<Index>(expected.size()), found.size()) << what;
  const double n = static_cast<double>(s.size()), norm = f.w.norm();
  for (Index k = 0; k < found.size(); ++k) EXPECT_NEAR(found(k), expected[static_cast<std::size_t>(k)], 100 * n * epsilon * norm) << what;
  for (const Mode& m : r.modes) {
    if (m.omega == 0) continue;
    const ComplexVector u = f.displacement * m.shape + Complex(0, m.omega) * (f.velocity * m.shape);
    EXPECT_LE((f.w * u - m.omega * m.omega * u).norm(), 1e3 * n * epsilon * norm * u.norm()) << what << " at " << m.omega;
  }
}

}  // namespace

TEST(ConstantForm, General) {
  Source s{std::mt19937_64(1)};
  for (const Index n : {1, 2, 3, 5, 8, 30, 100}) {
    const System system(s.symmetric(n, 0), s.skew(n), s.symmetric(n, 0));
    expect_form(system, "general");
    const dense::ConstantForm f = form_of(system);
    if (!f.bidiagonal) continue;  // small ones have a partition
    EXPECT_LE((f.orthogonal->transpose() * *f.orthogonal - Matrix::Identity(2 * n, 2 * n)).norm(), 30 * static_cast<double>(n) * epsilon);
    for (Index i = 0; i < n; ++i) {
      for (Index k = 0; k < n; ++k) {
        if (std::abs(i - k) > 1) {
          EXPECT_EQ(f.w(i, k), 0);
        }
        if (k > i || i - k > 1) {
          EXPECT_EQ((*f.bidiagonal)(i, k), 0);
        }
      }
    }
  }
}

TEST(ConstantForm, PartitionVisibleAndHidden) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const support::Scrambled s = support::scrambled_system(seed, 16, 20);
    bool applies = true;
    try {
      form_of(s.plain);
    } catch (const NotApplicable&) {
      applies = false;
    }
    if (!applies) {
      EXPECT_THROW(form_of(s.hidden), NotApplicable);
      continue;
    }
    expect_form(s.plain, s.description.c_str());
    expect_form(s.hidden, s.description.c_str());
  }
}

TEST(ConstantForm, ZeroModes) {
  const Matrix k{{2, -2, 0}, {-2, 3, -1}, {0, -1, 1}};
  Matrix g = Matrix::Zero(3, 3);
  g(0, 2) = 0.8, g(2, 0) = -0.8;
  expect_form(System(Eigen::Vector3d(1, 2, 3).asDiagonal(), g, k), "free chain");
  Source s{std::mt19937_64(2)};
  Matrix free = s.symmetric(6, 0);
  const Vector u = s.gaussian(6, 1).normalized();
  free = (Matrix::Identity(6, 6) - u * u.transpose()) * free * (Matrix::Identity(6, 6) - u * u.transpose());
  expect_form(System(s.symmetric(6, 0), s.skew(6), symmetric_part(free)), "free, general");
}

TEST(ConstantForm, RefusedWithTheReason) {
  Source s{std::mt19937_64(3)};
  EXPECT_THROW(form_of(System(Matrix::Identity(5, 5), s.skew(5), s.symmetric(5, 2))), NotApplicable);
  EXPECT_THROW(form_of(System(Matrix::Identity(2, 2), Matrix{{0, -3}, {3, 0}}, Matrix{{-1, 0}, {0, -2}})), NotApplicable);
}
