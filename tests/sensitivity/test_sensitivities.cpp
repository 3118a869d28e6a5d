// ∂ω/∂p against roots in 100 digits, closed forms, and what scaling says.
#include "gyromode/base/error.h"
#include "gyromode/models/model.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/read/read_model.h"
#include "reference/characteristic_root.h"
#include "support/random_matrices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>

namespace gyromode {
namespace {

using support::Source;

const std::filesystem::path source_dir = GYROMODE_SOURCE_DIR;

ModesResult with_shapes(const Model& m, std::optional<Index> lowest = std::nullopt) {
  ModesOptions o;
  o.shapes = true;
  o.lowest = lowest;
  return m.modes(o);
}

Matrix entry(Index n, Index i, Index k, double mirror) {
  Matrix e = Matrix::Zero(n, n);
  e(k, i) = mirror;
  e(i, k) = 1;
  return e;
}

// Every entry of M, G and K of seeded systems of all classes, in units over 2^±30.
TEST(Sensitivities, OfEntriesAreThoseOf100Digits) {
  const char* count = std::getenv("GYROMODE_SENSITIVITIES");
  const int draws = count ? std::atoi(count) : 15;
  Source source{std::mt19937_64(5)};
  double worst = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const Index n = source.integer(2, 5);
    const double mass = std::ldexp(1.0, static_cast<int>(source.integer(-30, 30))),
                 time = std::ldexp(1.0, static_cast<int>(source.integer(-30, 30)));
    Matrix m = source.symmetric(n, 0), g = source.skew(n), k = source.symmetric(n, draw % 3 == 0 ? 1 : 0);
    if (draw % 2 == 0) support::make_quadrature(m, g, k);
    if (draw % 5 == 0) g *= 30;
    const Model model(System(mass * m, mass / time * g, mass / (time * time) * k));
    const System& s = *model.body->second_order();
    const ModesResult r = with_shapes(model);
    const Matrix zero = Matrix::Zero(n, n);
    for (const char* name : {"mass", "gyroscopic", "stiffness"}) {
      const bool skew = std::string(name) == "gyroscopic";
      for (Index i = 0; i < n; ++i) {
        for (Index c = i + (skew ? 1 : 0); c < n; ++c) {
          const std::string key = std::string(name) + "[" + std::to_string(i) + "][" + std::to_string(c) + "]";
          if (!model.body->parameter(key)) continue;
          const Matrix e = entry(n, i, c, i == c ? 1 : skew ? -1 : 1);
          const auto found = model.sensitivities(r.modes, {key});
          ASSERT_EQ(found.size(), 1U);
          for (std::size_t q = 0; q < r.modes.size(); ++q) {
            const double exact = reference::slope_of_root(s.mass(), s.gyroscopic(), s.stiffness(), name[0] == 'm' ? e : zero,
                                                          skew ? e : zero, name[0] == 's' ? e : zero, r.modes[q].omega);
            // The largest that an entry of this size can do is the scale of what cancels in the form of a shape.
            const ComplexVector& x = r.modes[q].shape;
            const double power = name[0] == 'm' ? r.modes[q].omega * r.modes[q].omega : skew ? r.modes[q].omega : 1;
            const double scale = power * x.squaredNorm() / std::abs(r.modes[q].form);
            worst = std::max(worst, std::abs(found[0].slope[q] - exact) / std::max(std::abs(exact), 1e-3 * scale));
            EXPECT_NEAR(found[0].slope[q], exact, 1e-9 * std::max(std::abs(exact), 1e-3 * scale)) << draw << " " << key << " " << q;
          }
        }
      }
    }
  }
  std::printf("worst %.1e\n", worst);
}

// Two equal oscillators: a stiffness splits them, a coupling too, and to both sides.
TEST(Sensitivities, OfDoubleModesAreTheEigenvaluesOfTheSmallMatrix) {
  const double k = 4, m = 1.5, w = std::sqrt(k / m);
  const Model model(System(m * Matrix::Identity(2, 2), Matrix::Zero(2, 2), k * Matrix::Identity(2, 2)));
  const ModesResult r = with_shapes(model);
  const auto one = model.sensitivities(r.modes, {"stiffness[0][0]"}), coupling = model.sensitivities(r.modes, {"stiffness[0][1]"});
  EXPECT_NEAR(one[0].slope[0], 0, 1e-12);
  EXPECT_NEAR(one[0].slope[1], 1 / (2 * w * m), 1e-12);
  EXPECT_NEAR(coupling[0].slope[0], -1 / (2 * w * m), 1e-12);
  EXPECT_NEAR(coupling[0].slope[1], 1 / (2 * w * m), 1e-12);
}

// All stiffness by s² and the speed by s scales ω by s; all masses by s and G with them, and K too, does nothing.
TEST(Sensitivities, OfRotorsScale) {
  for (const char* name : {"two_discs.toml", "two_discs_orthotropic.toml", "twin_spool.toml", "overhung_disc.toml"}) {
    const Model model = read_model(source_dir / "models" / "rotors" / name);
    const ModesResult r = with_shapes(model, 6);
    const auto all = model.sensitivities(r.modes);
    for (std::size_t k = 0; k < r.modes.size(); ++k) {
      double stiffness = 0, speed = 0, open = 0;
      for (const Sensitivity& s : all) {
        const std::string& key = s.parameter.key;
        if (s.parameter.value == 0 || std::isnan(s.slope[k])) continue;
        const bool stiff = key.ends_with("young") || key.ends_with("shear") || key.find(".k") != std::string::npos ||
                           key.find(".tilt_") != std::string::npos || key.find("housing_k") != std::string::npos || key == "axial_force";
        if (stiff) stiffness += s.relative(k, r.modes[k].omega);
        if (key == "speed") speed = s.relative(k, r.modes[k].omega);
        if (stiff || key == "speed") open += std::abs(s.error[k] * s.parameter.value / r.modes[k].omega);
      }
      EXPECT_NEAR(stiffness + 0.5 * speed, 0.5, 1e-9 + open + 8 * r.modes[k].error_bound / r.modes[k].omega) << name << " " << k;
    }
  }
}

// All lengths by s, with moduli by 1/s, densities by 1/s³ and inertias by s², change the metre: ω stays. Discs and
// bearings stand between the ends of their section, so that every length has a derivative.
TEST(Sensitivities, OfRotorsDoNotKnowTheMetre) {
  const Model model = parse_model(R"(kind = "rotor"
speed = 200
[material.steel]
young = 2.1e11
shear = 8.1e10
density = 7800
[[shaft]]
length = 1.5
outer_diameter = [0.05, 0.06]
inner_diameter = 0.01
elements = 6
material = "steel"
[[disk]]
position = 0.5
offset = 0.02
mass = 20
polar_inertia = 0.3
diametral_inertia = 0.17
[[disk]]
position = 1.0
width = 0.07
inner_diameter = 0.05
outer_diameter = 0.35
material = "steel"
[[bearing]]
position = 0.25
kxx = 1e6
kyy = 2e6
[[bearing]]
position = 1.25
kxx = 1e6
kyy = 2e6
)",
                                  "rotor.toml");
  const ModesResult r = with_shapes(model, 6);
  const auto all = model.sensitivities(r.modes);
  for (std::size_t k = 0; k < r.modes.size(); ++k) {
    if (r.modes[k].kind == ModeKind::rigid_body) continue;
    double sum = 0, open = 0, largest = 0;
    for (const Sensitivity& s : all) {
      const std::string& key = s.parameter.key;
      if (s.parameter.value == 0) continue;
      const bool modulus = key.ends_with("young") || key.ends_with("shear");
      const bool length = key.ends_with("position") || key.ends_with("length") || key.find("diameter") != std::string::npos ||
                          key.ends_with("offset") || key.ends_with("width");
      const double metres = modulus ? -1 : key.ends_with("density") ? -3 : key.ends_with("_inertia") ? 2 : length ? 1 : 0;
      if (metres == 0) continue;
      ASSERT_FALSE(std::isnan(s.slope[k])) << key;
      const double part = metres * s.relative(k, r.modes[k].omega);
      sum += part;
      largest = std::max(largest, std::abs(part));
      open += std::abs(metres * s.error[k] * s.parameter.value / r.modes[k].omega);
    }
    EXPECT_GT(largest, 0.1);
    EXPECT_NEAR(sum, 0, 1e-9 + open) << k;
    EXPECT_LT(open, 1e-6) << k;
  }
}

// What only spin holds has frequencies that go with the spin.
TEST(Sensitivities, OfWiresToTheSpinAreTheirFrequencies) {
  for (const char* name : {"geos.toml", "themis.toml"}) {
    const Model model = read_model(source_dir / "models" / name);
    if (!model.body->parameter("beam[0].length")) {
      const ModesResult r = with_shapes(model, 6);
      const auto spin = model.sensitivities(r.modes, {"spin"});
      for (std::size_t k = 0; k < r.modes.size(); ++k) {
        if (std::isnan(spin[0].slope[k])) continue;
        EXPECT_NEAR(spin[0].relative(k, r.modes[k].omega), 1, 1e-9) << name << " " << k;
      }
    }
  }
}

// Booms on axis and wires: against differences of the frequencies themselves.
TEST(Sensitivities, OfSpacecraftAreThoseOfTheirFrequencies) {
  const Model model = read_model(source_dir / "models" / "ulysses.toml");
  const ModesResult r = with_shapes(model, 5);
  for (const char* key : {"beam[0].length", "body.inertia[2]", "spin", "body.mass"}) {
    if (!model.body->parameter(key)) continue;
    const auto s = model.sensitivities(r.modes, {key});
    const double p = s[0].parameter.value, h = 1e-4 * p;
    std::vector<std::vector<double>> at;
    for (const int step : {-2, -1, 1, 2}) at.push_back(with_shapes(model.with({{key, p + step * h}}), 5).frequencies());
    for (std::size_t k = 0; k < r.modes.size(); ++k) {
      if (std::isnan(s[0].slope[k])) continue;
      const double by_differences = (8 * (at[2][k] - at[1][k]) - (at[3][k] - at[0][k])) / (12 * h);
      EXPECT_NEAR(s[0].slope[k], by_differences, 1e-7 * (std::abs(by_differences) + r.modes[k].omega / p)) << key << " " << k;
    }
  }
}

// Critical speeds: of a bearing, against those of the changed rotor.
TEST(Sensitivities, OfCriticalSpeedsAreThoseOfTheChangedRotor) {
  const Model model = read_model(source_dir / "models" / "rotors" / "two_discs_orthotropic.toml");
  CriticalOptions o;
  o.lowest = 5;
  const CriticalSpeeds found = model.critical_speeds(o);
  for (const char* key : {"bearing[0].kxx", "material.steel.young", "disk[0].outer_diameter"}) {
    const auto s = model.sensitivities(found, {key});
    const double p = s[0].parameter.value, h = 1e-3 * p;
    std::vector<CriticalSpeeds> at;
    for (const int step : {-2, -1, 1, 2}) at.push_back(model.with({{key, p + step * h}}).critical_speeds(o));
    for (std::size_t k = 0; k < found.speeds.size(); ++k) {
      const auto speed = [&](std::size_t i) { return at[i].speeds[k].speed; };
      const double by_differences = (8 * (speed(2) - speed(1)) - (speed(3) - speed(0))) / (12 * h);
      EXPECT_NEAR(s[0].slope[k], by_differences, 1e-7 * (std::abs(by_differences) + found.speeds[k].speed / p)) << key << " " << k;
    }
  }
}

TEST(Sensitivities, BadRequestsAreRefused) {
  const Model model = read_model(source_dir / "models" / "rotors" / "jeffcott.toml");
  EXPECT_THROW(model.sensitivities(model.modes({}).modes), InvalidArgument);  // no shapes
  EXPECT_THROW(model.sensitivities(with_shapes(model).modes, {"bearing[7].kxx"}), InvalidArgument);
}

}  // namespace
}  // namespace gyromode
