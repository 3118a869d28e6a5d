// The exact Rayleigh shaft: closed forms, and finite elements that converge to it.
#include "gyromode/base/error.h"
#include "gyromode/modes/modes.h"
#include "gyromode/roots/certified_roots.h"
#include "gyromode/rotor/exact_rotor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace gyromode {
namespace {

struct Shaft {
  double length = 1.3, diameter = 0.1, speed = 900, tension = 0;
  RotorParts parts(Index elements) const {
    RotorParts p;
    p.speed = speed;
    p.axial_force = tension;
    p.materials = {{"steel", 2.1e11, 8.1e10, 7800}};
    ShaftSection s;
    s.material = "steel";
    s.length = length;
    for (double& d : s.outer_diameter) d = diameter;
    s.elements = elements;
    s.theory = ShaftTheory::rayleigh;
    p.shafts = {s};
    return p;
  }
  Rotor pinned(Index elements) const {
    RotorParts p = parts(elements);
    for (const double z : {0.0, length}) {
      Support held;
      held.position = z;
      held.x = held.y = true;
      p.supports.push_back(held);
    }
    return Rotor(p);
  }
  Rotor on_bearings(Index elements, double kyy) const {
    RotorParts p = parts(elements);
    for (const double z : {0.0, length}) {
      Bearing b;
      b.position = z;
      b.kxx = 3e7;
      b.kyy = kyy;
      p.bearings.push_back(b);
    }
    Disc d;
    d.position = 0.5 * length;
    d.mass = 30;
    d.polar_inertia = 0.9;
    d.diametral_inertia = 0.5;
    p.discs = {d};
    return Rotor(p);
  }
};

std::vector<double> exact_modes(const Rotor& r, double below) {
  const ExactRotor h(r);
  EXPECT_GT(h.reach(), below);
  const CertifiedRoots roots(h, {}, {}, 0, [](Index) { return std::nullopt; });
  std::vector<double> all;
  for (const Root& root : roots.between(0, below).roots) all.push_back(root.omega);
  EXPECT_EQ(roots.below(below), static_cast<Index>(all.size()));
  return all;
}

std::vector<double> element_modes(const Rotor& r, std::size_t count) {
  ModesOptions o;
  o.lowest = static_cast<Index>(count);
  std::vector<double> all = find_modes(assembled(r).at(r.parts().speed), o).frequencies();
  all.resize(count);
  return all;
}

// sin(kz) solves it: EIk⁴ + Nk² − ρI(ω² − 2Ωω)k² ... = ρAω².
TEST(ExactShaft, OfAPinnedShaftIsTheClosedForm) {
  for (const double speed : {0.0, 900.0, 5000.0}) {
    for (const double tension : {0.0, 2e5, -1e5}) {
      Shaft s;
      s.speed = speed;
      s.tension = tension;
      const double radius = s.diameter / 2, area = std::numbers::pi * radius * radius, second = area * radius * radius / 4, rho = 7800,
                   e = 2.1e11;
      std::vector<double> known;
      for (int n = 1; n <= 3; ++n) {
        const double k = n * std::numbers::pi / s.length;
        // (ρA + ρIk²)ω² − 2ΩρIk²ω − (EIk⁴ + Nk²) = 0
        const double m = rho * area + rho * second * k * k, g = speed * rho * second * k * k,
                     c = e * second * k * k * k * k + tension * k * k;
        for (const double whirl : {-1.0, 1.0}) known.push_back((whirl * g + std::sqrt(g * g + m * c)) / m);
      }
      std::sort(known.begin(), known.end());
      const std::vector<double> found = exact_modes(s.pinned(6), 1.05 * known.back());
      ASSERT_EQ(found.size(), known.size()) << speed << " " << tension;
      for (std::size_t i = 0; i < known.size(); ++i) EXPECT_NEAR(found[i], known[i], 2e-11 * known[i]) << speed << " " << tension;
    }
  }
}

TEST(ExactShaft, DoesNotDependOnHowItIsDivided) {
  const Shaft s;
  const std::vector<double> coarse = exact_modes(s.on_bearings(4, 2e7), 5000), fine = exact_modes(s.on_bearings(12, 2e7), 5000);
  ASSERT_EQ(coarse.size(), fine.size());
  for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_NEAR(coarse[i], fine[i], 1e-11 * fine[i]);
}

// Finite elements of length h are wrong by h⁴: 24, 48 and 96 of them, extrapolated, are the exact ones.
TEST(ExactShaft, IsTheLimitOfFiniteElements) {
  for (const double kyy : {3e7, 1e7}) {
    for (const double tension : {0.0, 3e5}) {
      Shaft s;
      s.tension = tension;
      const std::vector<double> exact = exact_modes(s.on_bearings(8, kyy), 6000);
      ASSERT_GE(exact.size(), 6U);
      const std::vector<double> at24 = element_modes(s.on_bearings(24, kyy), exact.size()),
                                at48 = element_modes(s.on_bearings(48, kyy), exact.size()),
                                at96 = element_modes(s.on_bearings(96, kyy), exact.size());
      for (std::size_t i = 0; i < exact.size(); ++i) {
        const double e24 = at24[i] / exact[i] - 1, e48 = at48[i] / exact[i] - 1;
        if (std::abs(e48) > 1e-9) {
          EXPECT_NEAR(std::log2(e24 / e48), 4, 0.15) << kyy << " " << i;  // the order
        }
        const double first = (16 * at48[i] - at24[i]) / 15, second = (16 * at96[i] - at48[i]) / 15;
        EXPECT_NEAR((64 * second - first) / 63, exact[i], 1e-9 * exact[i]) << kyy << " " << tension << " " << i;
      }
    }
  }
}

// What 200 elements are off is what rounding of their matrices does to them, as they say themselves.
TEST(ExactShaft, TwoHundredElementsAreThere) {
  const Shaft s;
  const std::vector<double> exact = exact_modes(s.on_bearings(8, 2e7), 6000);
  ModesOptions o;
  o.lowest = static_cast<Index>(exact.size());
  const std::vector<Mode> at200 = find_modes(assembled(s.on_bearings(200, 2e7)).at(s.speed), o).modes;
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(at200[i].omega, exact[i], at200[i].error_bound + 1e-9 * exact[i]) << i;
}

TEST(ExactShaft, OtherShaftsAreRefused) {
  Shaft s;
  RotorParts p = s.parts(4);
  p.shafts[0].theory = ShaftTheory::timoshenko;
  EXPECT_THROW(ExactRotor{Rotor(p)}, NotApplicable);
  p.shafts[0].theory = ShaftTheory::rayleigh;
  p.shafts[0].outer_diameter[1] = 0.05;
  EXPECT_THROW(ExactRotor{Rotor(p)}, NotApplicable);
}

}  // namespace
}  // namespace gyromode
