// Rotors against published numbers, closed forms, and each other.
#include "gyromode/base/error.h"
#include "gyromode/lapack/small.h"
#include "gyromode/modes/modes.h"
#include "gyromode/read/read_model.h"
#include "gyromode/rotor/rotor.h"
#include "gyromode/rotor/shaft_element.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace gyromode {
namespace {

constexpr double pi = std::numbers::pi, rpm = pi / 30;
const double inf = std::numeric_limits<double>::infinity();

std::vector<double> frequencies(const Rotor& r, Index count) {
  ModesOptions options;
  options.lowest = count;
  const ModesResult result = find_modes(assembled(r).at(r.parts().speed), options);
  EXPECT_TRUE(result.is_complete()) << result.coverage.reason;
  return result.frequencies();
}

void expect(const Rotor& r, const std::vector<double>& known, double relative, double unit = 1) {
  const std::vector<double> found = frequencies(r, static_cast<Index>(known.size()));
  ASSERT_GE(found.size(), known.size());
  for (std::size_t k = 0; k < known.size(); ++k) EXPECT_NEAR(found[k] / unit, known[k], relative * known[k]) << k;
}

// Friswell, Penny, Garvey & Lees 2010, Example 5.9.1 (p. 206): two discs, bearings at the ends.
RotorParts two_discs(double speed, double kxx, double kyy, Index elements) {
  RotorParts p;
  p.speed = speed;
  p.materials = {{"steel", 211e9, 81.2e9, 7810}};
  ShaftSection s;
  s.material = "steel";
  s.length = 1.5;
  s.outer_diameter[0] = s.outer_diameter[1] = 0.05;
  s.elements = elements;
  p.shafts = {s};
  for (const auto& [position, diameter] : {std::pair(0.5, 0.28), {1.0, 0.35}}) {
    Disc d;
    d.position = position;
    d.geometry = DiscGeometry{"steel", 0.07, 0.05, diameter};
    p.discs.push_back(d);
  }
  for (const double position : {0.0, 1.5}) {
    Bearing b;
    b.position = position;
    b.kxx = kxx;
    b.kyy = kyy;
    p.bearings.push_back(b);
  }
  return p;
}

TEST(PublishedRotors, TwoDiscsOnIsotropicBearings) {
  expect(Rotor(two_discs(0, 1e6, 1e6, 6)), {86.65811, 86.65811, 274.31285, 274.31285, 716.78631, 716.78631}, 1e-7);
  expect(Rotor(two_discs(4000 * rpm, 1e6, 1e6, 6)),
         {85.38947, 87.79586, 251.78460, 294.71333, 600.17936, 827.07536, 1038.99552, 1088.19300}, 1e-7);
  expect(Rotor(two_discs(4000 * rpm, 1e6, 1e6, 48)), {85.38937, 87.79576, 251.78054, 294.70587, 600.08180, 826.65897}, 1e-7);
}

TEST(PublishedRotors, TwoDiscsOnOrthotropicBearings) {
  expect(Rotor(two_discs(0, 1e6, 0.8e6, 6)), {82.65304, 86.65811, 254.52048, 274.31285, 679.48903, 716.78631}, 1e-7);
  expect(Rotor(two_discs(4000 * rpm, 1e6, 0.8e6, 6)),
         {82.32547, 86.86370, 239.64228, 287.24958, 583.48783, 806.88728, 1018.52800, 1075.26132}, 1e-7);
}

// Gibert, Vibrations des structures, pp. 235–237 (code_aster SDLL141A): a simply supported shaft, rotary inertia of the
// slices left out of M or kept.
RotorParts simply_supported(double speed, ShaftTheory theory, Index elements) {
  RotorParts p;
  p.speed = speed;
  p.materials = {{"steel", 2e11, 1e11, 7800}};
  ShaftSection s;
  s.material = "steel";
  s.length = 0.9;
  s.outer_diameter[0] = s.outer_diameter[1] = 0.05;
  s.elements = elements;
  s.theory = theory;
  p.shafts = {s};
  for (const double position : {0.0, 0.9}) {
    Support at;
    at.position = position;
    at.x = at.y = true;
    p.supports.push_back(at);
  }
  return p;
}

// ω²(1 + r) ∓ 2Ωrω·… of mode n, backward and forward: λ = nπ/L, ω₀ = λ²√(EI/ρA), i = λ²I/A.
std::pair<double, double> gibert(int n, double speed, bool rotary) {
  const double lambda = n * pi / 0.9, ratio = lambda * lambda * 0.025 * 0.025 / 4,
               w0 = lambda * lambda * std::sqrt(2e11 / 7800) * 0.025 / 2;
  const double mass = rotary ? 1 + ratio : 1, g = 2 * speed * ratio;
  const double root = std::sqrt(g * g + 4 * mass * w0 * w0);
  return {(root - g) / (2 * mass), (root + g) / (2 * mass)};
}

TEST(PublishedRotors, SimplySupportedShaft) {
  expect(Rotor(simply_supported(1e4, ShaftTheory::euler, 18)),
         {119.754862579, 125.815033727, 479.024176724, 503.264862154, 1077.85023, 1132.39181, 1916.39580, 2013.35888}, 1e-8, 2 * pi);
  expect(Rotor(simply_supported(1e4, ShaftTheory::rayleigh, 100)),
         {119.64375, 125.69241, 477.25011, 501.30758, 1068.89931, 1122.52204, 1888.23706, 1982.33346}, 1e-6, 2 * pi);
}

TEST(Rotors, ConvergeWithTheFourthPowerToTheExactShaft) {
  for (const bool rotary : {false, true}) {
    const ShaftTheory theory = rotary ? ShaftTheory::rayleigh : ShaftTheory::euler;
    const std::vector<double> coarse = frequencies(Rotor(simply_supported(5000, theory, 20)), 8),
                              fine = frequencies(Rotor(simply_supported(5000, theory, 40)), 8);
    for (int n = 1; n <= 4; ++n) {
      const auto [backward, forward] = gibert(n, 5000, rotary);
      for (const auto& [exact, k] : {std::pair(backward, 2 * n - 2), {forward, 2 * n - 1}}) {
        const auto at = static_cast<std::size_t>(k);
        EXPECT_NEAR(std::log2((coarse[at] - exact) / (fine[at] - exact)), 4, 0.1) << rotary << n;
        EXPECT_NEAR((16 * fine[at] - coarse[at]) / 15, exact, 2e-6 * exact) << rotary << n;
      }
    }
  }
}

// A uniform piece: the matrices of Nelson (1980), in which Φ = 12EI/(κGAl²).
TEST(ShaftElements, UniformOnesAreNelsons) {
  const Material steel{"steel", 211e9, 81.2e9, 7810};
  const CrossSection tube{0.08, 0.05};
  const double l = 0.13, ei = steel.young * tube.second_moment(), a = tube.area();
  const double phi = 12 * ei / (tube.shear_coefficient(steel.poisson()) * steel.shear * a * l * l);
  const ShaftElement e = shaft_element({steel, l, tube, tube, ShaftTheory::timoshenko, {}});
  Matrix k(4, 4), m(4, 4), r(4, 4);
  k << 12, 6 * l, -12, 6 * l, 6 * l, (4 + phi) * l * l, -6 * l, (2 - phi) * l * l, -12, -6 * l, 12, -6 * l, 6 * l, (2 - phi) * l * l,
      -6 * l, (4 + phi) * l * l;
  k *= ei / ((1 + phi) * l * l * l);
  const double m1 = 312 + 588 * phi + 280 * phi * phi, m2 = (44 + 77 * phi + 35 * phi * phi) * l, m3 = 108 + 252 * phi + 140 * phi * phi,
               m4 = -(26 + 63 * phi + 35 * phi * phi) * l, m5 = (8 + 14 * phi + 7 * phi * phi) * l * l,
               m6 = -(6 + 14 * phi + 7 * phi * phi) * l * l;
  m << m1, m2, m3, m4, m2, m5, -m4, m6, m3, -m4, m1, -m2, m4, m6, -m2, m5;
  m *= steel.density * a * l / (840 * (1 + phi) * (1 + phi));
  const double r1 = 36, r2 = (3 - 15 * phi) * l, r3 = (4 + 5 * phi + 10 * phi * phi) * l * l, r4 = (-1 - 5 * phi + 5 * phi * phi) * l * l;
  r << r1, r2, -r1, r2, r2, r3, -r2, r4, -r1, -r2, r1, -r2, r2, r4, -r2, r3;
  r *= steel.density * tube.second_moment() / (30 * l * (1 + phi) * (1 + phi));
  EXPECT_LE((e.stiffness - k).norm(), 1e-13 * k.norm());
  EXPECT_LE((e.rotary - r).norm(), 1e-13 * r.norm());
  EXPECT_LE((e.mass - m - r).norm(), 1e-13 * m.norm());
}

// Statics of a taper are exact whatever the number of elements: a cantilever cone under an end load.
TEST(ShaftElements, TapersAreExactForStatics) {
  const Material steel{"steel", 2e11, 8e10, 7800};
  const auto tip = [&](Index pieces, double share) {  // of all of them in a row, by the compliance at the tip
    Matrix k = Matrix::Zero(2 * pieces + 2, 2 * pieces + 2);
    for (Index e = 0; e < pieces; ++e) {
      const auto diameter = [&](Index end) { return 0.1 - share * static_cast<double>(end) / static_cast<double>(pieces); };
      k.block(2 * e, 2 * e, 4, 4) +=
          shaft_element({steel, 1.0 / static_cast<double>(pieces), {diameter(e), 0}, {diameter(e + 1), 0}, ShaftTheory::rayleigh, {}})
              .stiffness;
    }
    const Matrix free = k.bottomRightCorner(2 * pieces, 2 * pieces);
    return small::inverse(free)(2 * pieces - 2, 2 * pieces - 2);
  };
  EXPECT_NEAR(tip(1, 0.05), tip(8, 0.05), 1e-11 * tip(8, 0.05));
  EXPECT_NEAR(tip(1, 0), 1 / (3 * 2e11 * pi / 64 * 1e-4), 1e-12);
  // d = 0.1(1 − z/2): ∫(1 − z)²/EI dz by hand: 64/(πE·1e-4) · ∫(1 − z)²/(1 − z/2)⁴ = 64/(πE·1e-4) · 2/3
  EXPECT_NEAR(tip(1, 0.05), 64 / (pi * 2e11 * 1e-4) * 2 / 3, 1e-11 * tip(1, 0.05));
}

// A string: a slender shaft under great tension.
TEST(Rotors, TensionStiffens) {
  RotorParts p = simply_supported(0, ShaftTheory::euler, 40);
  p.shafts[0].outer_diameter[0] = p.shafts[0].outer_diameter[1] = 1e-3;
  p.axial_force = 1e5;
  const double density = 7800 * pi / 4 * 1e-6, bending = 2e11 * pi / 64 * 1e-12;
  const std::vector<double> found = frequencies(Rotor(p), 6);
  for (int n = 1; n <= 3; ++n) {
    const double lambda = n * pi / 0.9, exact = std::sqrt((1e5 * lambda * lambda + bending * std::pow(lambda, 4)) / density);
    EXPECT_NEAR(found[static_cast<std::size_t>(2 * n - 1)], exact, 1e-5 * exact);
  }
}

// Two spools joined by a bearing that pins them to each other, at one speed, are one shaft with both masses.
TEST(Rotors, SpoolsPinnedTogetherMoveAlike) {
  RotorParts p = simply_supported(0, ShaftTheory::euler, 8);
  p.spools = {{"outer", 1, 0}, {"inner", -1, 0}};
  p.shafts.push_back(p.shafts[0]);
  p.shafts[0].spool = "outer";
  p.shafts[1].spool = "inner";
  for (Support& s : p.supports) s.spool = "outer";
  for (int k = 0; k <= 8; ++k) {
    Bearing b;
    b.position = 0.9 * k / 8;
    b.kxx = b.kyy = b.tilt_xx = b.tilt_yy = inf;
    b.spool = "inner";
    b.to = "outer";
    p.bearings.push_back(b);
  }
  const Rotor two(p), one(simply_supported(0, ShaftTheory::euler, 8));
  EXPECT_EQ(two.size(), one.size());
  const std::vector<double> a = frequencies(two, 4), b = frequencies(one, 4);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(a[k], b[k], 1e-11 * b[k]);
  p.speed = 1e4;  // the gyroscopic moments of the two are opposite
  const std::vector<double> c = frequencies(Rotor(p), 4);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(c[k], b[k], 1e-11 * b[k]);
}

// A mass on a rigid stub, on a bearing in a housing: two springs in a row.
TEST(Rotors, HousingsStandBetweenBearingAndGround) {
  RotorParts p = simply_supported(0, ShaftTheory::euler, 1);
  p.supports.clear();
  p.shafts[0].length = 0.01;
  p.shafts[0].outer_diameter[0] = p.shafts[0].outer_diameter[1] = 1;
  for (const double position : {0.0, 0.01}) {
    Bearing b;
    b.position = position;
    b.kxx = b.kyy = 3e6;
    b.housing_kxx = 6e6;
    b.housing_kyy = 1.5e6;
    b.housing_mass = 0.001;
    p.bearings.push_back(b);
  }
  const double mass = 7800 * pi / 4 * 0.01;
  const std::vector<double> found = frequencies(Rotor(p), 2);
  EXPECT_NEAR(found[0], 0, 1e3);
  const Rotor r(p);
  EXPECT_EQ(r.size(), 12);
  EXPECT_EQ(r.labels().back(), "bearing2.y");
  const SpinFamily f = assembled(r);
  EXPECT_NEAR(f.mass(0, 0) + 2 * f.mass(0, 4) + f.mass(4, 4), mass, 1e-12 * mass);
}

std::string said(const RotorParts& p) {
  try {
    Rotor r(p);
  } catch (const LawBroken& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Rotors, RefusalsNameThePart) {
  RotorParts p = two_discs(0, 1e6, 1e6, 6);
  const auto with = [&](auto&& change) {
    RotorParts q = p;
    change(q);
    return said(q);
  };
  EXPECT_EQ(said(p), "accepted");
  EXPECT_EQ(with([](RotorParts& q) { q.discs[1].position = 2; }), "disk 2: position 2 m is off the shaft, which reaches from 0 to 1.5 m");
  EXPECT_EQ(with([](RotorParts& q) { q.shafts[0].material = "stel"; }),
            "material 'stel' is not given: a table [material.stel] was expected: did you mean 'steel'?");
  EXPECT_EQ(with([](RotorParts& q) { q.shafts[0].inner_diameter[0] = 0.06; }),
            "shaft 1: 'inner_diameter' must be below the outer one: 0.06 m ≥ 0.05 m");
  EXPECT_EQ(with([](RotorParts& q) { q.bearings[0].kxx = -1; }), "bearing 1: 'kxx' must not be below 0 (inf: pinned): it is -1");
  EXPECT_EQ(with([](RotorParts& q) { q.bearings[0].to = "LP"; }).substr(0, 29), "'LP' is no spool of the rotor");
  EXPECT_EQ(with([](RotorParts& q) { q.discs[0].geometry.reset(), q.discs[0].polar_inertia = 1; }).substr(0, 70),
            "disk 1: 'polar_inertia' must obey the triangle inequality, at most twi");
  EXPECT_EQ(with([](RotorParts& q) { q.materials[0].shear = 1e9; }).substr(0, 57),
            "material 'steel': 'shear' must leave Poisson's ratio E/2G");
  EXPECT_EQ(with([](RotorParts& q) { q.shafts.clear(); }), "a rotor must have a shaft: at least one section was expected");
}

// Two shafts that meet in a coupling: rigid, they are one; hinged, they do not pass bending on, and the frequencies of
// a shaft cut in its middle are below.
TEST(Rotors, CouplingOfTwoShafts) {
  const std::string head = "kind = \"rotor\"\nspeed = 300\n[material.steel]\nyoung = 2.1e11\nshear = 8.1e10\ndensity = 7800\n";
  const auto shaft = [](double length, const char* spool) {
    return fmt::format("[[shaft]]\nlength = {}\nouter_diameter = 0.05\nelements = 4\nmaterial = \"steel\"\n{}", length, spool);
  };
  const auto bearings = [](const char* a, const char* b) {
    return fmt::format("[[bearing]]\nposition = 0\nkxx = 1e7\nkyy = 2e7\n{}[[bearing]]\nposition = 1\nkxx = 1e7\nkyy = 2e7\n{}", a, b);
  };
  const auto coupled = [&](const char* tilt) {
    return head + "[spool.driver]\n[spool.driven]\nstart = 0.5\n" + shaft(0.5, "spool = \"driver\"\n") +
           shaft(0.5, "spool = \"driven\"\n") + bearings("spool = \"driver\"\n", "spool = \"driven\"\n") +
           fmt::format(
               "[[bearing]]\nposition = 0.5\nspool = \"driver\"\nto = \"driven\"\nkxx = inf\nkyy = inf\ntilt_xx = {0}\ntilt_yy = {0}\n",
               tilt);
  };
  const std::string whole = head + shaft(0.5, "") + shaft(0.5, "") + bearings("", "");
  const auto frequencies = [](const std::string& text) { return parse_model(text, "rotor.toml").modes().frequencies(); };
  const std::vector<double> one = frequencies(whole), rigid = frequencies(coupled("inf")), hinged = frequencies(coupled("1e3"));
  ASSERT_EQ(one.size(), rigid.size());
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_NEAR(rigid[k], one[k], 1e-9 * one[k]);
  ASSERT_EQ(hinged.size(), one.size() + 2);
  EXPECT_LT(hinged[0], 0.8 * one[0]);
}

}  // namespace
}  // namespace gyromode
