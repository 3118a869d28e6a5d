// What parts state of their couplings against their matrices: what is not stated is exactly zero at any frequency, and
// what is stated is there.
#include "support/random_spacecraft.h"

#include "gyromode/roots/blocks.h"
#include "gyromode/spacecraft/spacecraft_impedance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace gyromode {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rigid = std::numeric_limits<double>::infinity();

struct Worst {
  double unstated = 0;                 // largest entry where none is stated
  std::size_t stated = 0, absent = 0;  // couplings stated, and those of them that no frequency showed
  bool equal = true;                   // equal coordinates have equal entries
};

Worst compared(const SpacecraftImpedance& impedance, std::uint64_t seed) {
  const Couplings couplings = impedance.couplings();
  const Index n = impedance.size();
  Worst w;
  Matrix in_phase = Matrix::Zero(n, n), cross = Matrix::Zero(n, n);
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> decade(-4, 2), angle(-1.5, 0);
  for (int k = 0; k < 24; ++k) {
    const double omega = std::pow(10, decade(engine));
    const Lifted lifted = impedance.at(omega);
    const ComplexMatrix& h = lifted.matrix;
    in_phase = in_phase.cwiseMax(h.real().cwiseAbs());
    cross = cross.cwiseMax(h.imag().cwiseAbs());
    const ComplexMatrix continued = impedance.at(std::polar(std::min(omega, 5.0), angle(engine)));
    for (Index i = 0; i < n; ++i) {
      const Index first = couplings.first_of_equals(i);
      const auto s = static_cast<std::size_t>(i), f = static_cast<std::size_t>(first);
      w.equal = w.equal && h(i, i) == h(first, first) && lifted.poles_below[s] == lifted.poles_below[f] &&
                continued(i, i) == continued(first, first);
      for (Index j = 0; j < n; ++j) {
        if (i == j) continue;
        const bool p = couplings.meet(i, j, CouplingKind::in_phase), c = couplings.meet(i, j, CouplingKind::cross);
        if (!p) w.unstated = std::max(w.unstated, std::abs(h(i, j).real()));
        if (!c) w.unstated = std::max(w.unstated, std::abs(h(i, j).imag()));
        if (!p && !c) w.unstated = std::max(w.unstated, std::abs(continued(i, j)));
      }
    }
  }
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < i; ++j) {
      for (const auto& [kind, largest] : {std::pair(CouplingKind::in_phase, in_phase(i, j)), std::pair(CouplingKind::cross, cross(i, j))}) {
        if (!couplings.meet(i, j, kind)) continue;
        ++w.stated;
        w.absent += largest == 0 ? 1 : 0;
      }
    }
  }
  return w;
}

void expect_as_stated(const Spacecraft& s, std::uint64_t seed) {
  const Worst w = compared(SpacecraftImpedance(s), seed);
  EXPECT_EQ(w.unstated, 0) << seed;
  EXPECT_EQ(w.absent, 0u) << seed << ", of " << w.stated;
  EXPECT_TRUE(w.equal) << seed;
}

TEST(Couplings, OfRandomSatellites) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) expect_as_stated(random_spacecraft(seed), seed);
}

TEST(Couplings, OfSpecialOnes) {
  const Body body{100, Eigen::Vector3d(90, 110, 150).asDiagonal()};
  const Eigen::Matrix3d turned{{90, 5, 0}, {5, 110, 0}, {0, 0, 150}};
  std::vector<Cable> ring, up_and_down;
  for (const double degrees : {45, 135, 225, 315}) {
    ring.push_back({degrees * pi / 180, 0.9, 0.05, 40, 1.1e-3, 0.12});
    for (const double h : {-0.3, 0.3}) up_and_down.push_back({degrees * pi / 180, 0.9, h, 40, 1.1e-3, 0.12});
  }
  const std::vector<Spacecraft> all{
      Spacecraft(1, body),
      Spacecraft(1, {100, turned}),
      Spacecraft(1, {100, Eigen::Vector3d(90, 110, 200).asDiagonal()}),  // a lamina
      Spacecraft(1, body, ring),
      Spacecraft(1, body, up_and_down),
      Spacecraft(1, {100, turned}, ring, {{0.6, true, 6, 0.09, {900, 900}, 0.25}, {-0.6, false, 6, 0.09, {900, 900}, 0.25}}),
      Spacecraft(1, body, {}, {{0, true, 6, 0.09, {900, 300}, 0}}),
      Spacecraft(1, body, {{0.5 * pi, 0, 0, 20, 0.01, 0}, {1.5 * pi, 0, 0, 20, 0.01, 0}}),
      Spacecraft(1, body, {}, {}, {{{0, 0, 0.5}, 1, {5, 7, 9}}}),
      Spacecraft(1, body, {}, {}, {{{0.7, 0, 0}, 1, {5, rigid, 9}}, {{-0.7, 0, 0}, 1, {rigid, 7, 9}}}),
      Spacecraft(1, body, {}, {}, {{{0.7, 0.2, 0}, 1, {5, 7, rigid}}, {{-0.7, -0.2, 0}, 1, {rigid, rigid, 9}}})};
  for (std::size_t i = 0; i < all.size(); ++i) expect_as_stated(all[i], i);
}

// Symmetric satellites fall apart as far as their symmetry goes: what is stated is no more than there is.
TEST(Couplings, Blocks) {
  const auto blocks = [](const Spacecraft& s) { return blocks_of(SpacecraftImpedance(s)); };
  const Body body{100, Eigen::Vector3d(90, 110, 150).asDiagonal()};
  EXPECT_EQ(blocks(Spacecraft(1, body)).size(), 5u);  // ξ1, ξ2, ξ3, φ3 by themselves, and θ1 with θ2
  // Wires through the mass centre, whatever rounding makes of their height: translation, nutation, spin, axial motion,
  // and one pattern in plane and one out of it without the body.
  for (const double far : {0.0, 1e3}) {
    std::vector<Cable> ring;
    for (const double degrees : {0, 90, 180, 270}) ring.push_back({degrees * pi / 180, 0.9, 0.1, 40, 1.1e-3, 0.12});
    const double mass = 4 * ring[0].mass();
    const std::vector<SpringMass> balance{{{0, 0, 0.1 + 100 * 0.1 / 3 + far}, 3, {rigid, rigid, rigid}},
                                          {{0, 0, 0.1 - far}, 3, {rigid, rigid, rigid}}};
    const Spacecraft s(1, body, ring, {}, balance);
    EXPECT_NEAR(s.centre(), 0.1, 1e-12) << mass;
    EXPECT_EQ(blocks(s).size(), 6u) << far;
    for (const Block& b : blocks(s)) EXPECT_TRUE(b.real);
  }
}

}  // namespace
}  // namespace gyromode
