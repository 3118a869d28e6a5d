// Blocks rest on what an impedance states of itself, not on samples of it: a coupling that vanishes at any frequencies
// one may think of is one all the same.
#include "gyromode/roots/certified_roots.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace gyromode {
namespace {

// [k₁ − ω²  c(ω); ·  k₂ − ω²], c small, with zeros at some frequencies.
class TwoOscillators : public LiftedImpedance {
 public:
  explicit TwoOscillators(std::vector<double> zeros) : zeros_(std::move(zeros)) {}

  Index size() const override { return 2; }
  Couplings couplings() const override {
    Couplings c(2);
    c.add(0, 1, CouplingKind::in_phase);
    return c;
  }
  Lifted at(double omega) const override { return {at(Complex(omega)), {0, 0}}; }
  ComplexMatrix at(Complex omega) const override {
    const Complex c = coupling(omega), square = omega * omega;
    return ComplexMatrix{{1.44 - square, c}, {c, 1.69 - square}};
  }
  double rounding(double) const override { return 2 * std::numeric_limits<double>::epsilon(); }
  Complex coupling(Complex omega) const {
    Complex c = 0.02;
    for (const double z : zeros_) c *= (omega * omega - z * z) / (omega * omega + z * z);
    return c;
  }

 private:
  std::vector<double> zeros_;
};

TEST(Blocks, ACouplingThatVanishesAtSamplesIsACoupling) {
  for (const std::vector<double>& zeros : {std::vector<double>{}, {0.6180339887, 1.7320508076, 4.6692016091}, {1.0}, {0.5, 1, 2, 3, 4}}) {
    const TwoOscillators impedance(zeros);
    const CertifiedRoots roots(impedance, {}, {}, 0, [](Index) { return std::nullopt; });
    ASSERT_EQ(roots.blocked().blocks.size(), 1u);
    const std::vector<Root> found = roots.between(0, 1.5).roots;
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(roots.below(1.5), 2);
    for (const Root& r : found) {
      const ComplexMatrix h = impedance.at(Complex(r.omega));
      EXPECT_NEAR(std::abs(h.determinant()), 0, 1e-14);
      // Far from the roots of the diagonal, which blocks of one coordinate would give.
      EXPECT_GT(std::min(std::abs(h(0, 0)), std::abs(h(1, 1))), 1e-6);
    }
  }
}

TEST(Blocks, EqualCoordinatesAreOneBlockWithTwins) {
  Couplings c(5);
  c.add(0, 1, CouplingKind::cross);
  c.equal(2, 3);
  c.equal(2, 4);
  const std::vector<Block> blocks = blocks_of(c);
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0].coordinates, (std::vector<Index>{0, 1}));
  EXPECT_TRUE(blocks[0].real);
  EXPECT_EQ(blocks[1].equal_blocks, (std::vector<Index>{3, 4}));
  EXPECT_EQ(blocks[1].copies(), 3);
}

// A coupling of both kinds has no quadrature partition.
TEST(Blocks, InPhaseAndAcross) {
  Couplings c(2);
  c.add(0, 1, CouplingKind::cross);
  c.add(1, 0, CouplingKind::in_phase);
  c.add(0, 1, CouplingKind::in_phase);
  EXPECT_EQ(c.graph().neighbours[0].size(), 2u);
  ASSERT_EQ(blocks_of(c).size(), 1u);
  EXPECT_FALSE(blocks_of(c)[0].real);
}

}  // namespace
}  // namespace gyromode
