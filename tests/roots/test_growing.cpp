// Divergence and negative energy of q̈ + g [0 −1; 1 0] q̇ + diag(k₁, k₂) q = 0, whose λ² are the roots of x² + (g² + k₁ +
// k₂) x + k₁k₂.
#include "gyromode/roots/certified_roots.h"
#include "gyromode/roots/negative_energy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gyromode {
namespace {

class OnAHill : public LiftedImpedance {
 public:
  OnAHill(double g, double k1, double k2) : g_(g), k1_(k1), k2_(k2) {}

  Index size() const override { return 2; }
  Couplings couplings() const override {
    Couplings c(2);
    c.add(0, 1, CouplingKind::cross);
    return c;
  }
  Lifted at(double omega) const override { return {at(Complex(omega)), {0, 0}}; }
  ComplexMatrix at(Complex omega) const override {
    const Complex cross = Complex(0, -g_) * omega, square = omega * omega;
    return ComplexMatrix{{k1_ - square, cross}, {-cross, k2_ - square}};
  }
  double rounding(double) const override { return 2 * std::numeric_limits<double>::epsilon(); }

 private:
  double g_, k1_, k2_;
};

// No seeds are given: what is found follows from the impedance alone.
CertifiedRoots roots_of(const OnAHill& h) {
  return CertifiedRoots(h, {}, {}, 0, [](Index) { return std::nullopt; });
}

TEST(Growing, OneDivergenceHoweverSlow) {
  for (const double k : {1.0, 1e-2, 1e-6, 1e-10, 1e-12}) {
    const OnAHill h(0.5, -k, 2);
    const CertifiedRoots roots = roots_of(h);
    const double middle = 0.5 * (0.25 + 2 - k), x = 2 * k / (middle + std::sqrt(middle * middle + 2 * k));
    EXPECT_TRUE(roots.closed()) << k;
    EXPECT_FALSE(roots.asked_for_seeds());
    ASSERT_EQ(roots.growing().size(), 1u) << k;
    EXPECT_NEAR(roots.growing()[0].growth, std::sqrt(x), (1e-15 + 16 * std::numeric_limits<double>::epsilon() / k) * std::sqrt(x)) << k;
  }
}

TEST(Growing, TwoDivergences) {
  for (const double k : {1.0, 1e-3, 1e-6}) {
    const OnAHill h(0.5 * std::sqrt(k), -k, -4 * k);  // both real below g = √k
    const CertifiedRoots roots = roots_of(h);
    EXPECT_TRUE(roots.closed()) << k;
    ASSERT_EQ(roots.growing().size(), 2u) << k;
    const double a = std::sqrt(k) * 0.5 * (std::sqrt(9 - 0.25) - std::sqrt(1 - 0.25)), b = 2 * k / a;
    EXPECT_NEAR(roots.growing()[0].growth, a, 1e-9 * a);
    EXPECT_NEAR(roots.growing()[1].growth, b, 1e-9 * b);
  }
}

TEST(Growing, NegativeEnergyHoweverSlow) {
  for (const double k : {1.0, 1e-3, 1e-6, 1e-10}) {
    const OnAHill h(3, -k, -0.5);
    const CertifiedRoots roots = roots_of(h);
    EXPECT_TRUE(roots.closed()) << k;
    EXPECT_TRUE(roots.growing().empty());
    ASSERT_EQ(roots.negative_energy().size(), 1u) << k;
    const double middle = 0.5 * (9 - k - 0.5), x = 0.5 * k / (middle + std::sqrt(middle * middle - 0.5 * k));
    EXPECT_NEAR(roots.negative_energy()[0].omega, std::sqrt(x), (1e-14 + 64 * std::numeric_limits<double>::epsilon() / k) * std::sqrt(x))
        << k;
    EXPECT_EQ(roots.between(0, 10).roots.size(), 2u);
  }
}

// Flutter is nothing that signs and falls would show: the balance stays open without seeds, and closes with a poor one.
TEST(Growing, FlutterNeedsASeed) {
  const OnAHill h(2, -1, -4);  // |√4 − √1| < g < √4 + √1
  EXPECT_FALSE(roots_of(h).closed());
  const double growth = 0.5 * std::sqrt(9 - 4.0), omega = std::sqrt(2 - growth * growth);
  const CertifiedRoots roots(h, {}, {}, 0, [&](Index attempt) {
    return attempt == 0 ? std::optional(Seeds{{}, {Complex(1.02 * growth, 0.97 * omega)}}) : std::nullopt;
  });
  EXPECT_TRUE(roots.closed());
  EXPECT_TRUE(roots.asked_for_seeds());
  ASSERT_EQ(roots.growing().size(), 1u);
  EXPECT_NEAR(roots.growing()[0].growth, growth, 1e-14);
  EXPECT_NEAR(roots.growing()[0].omega, omega, 1e-14);
}

}  // namespace
}  // namespace gyromode
