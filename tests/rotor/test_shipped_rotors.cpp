// The models in models/rotors: what they declare to be known of them, and closed forms.
#include "gyromode/models/model.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/read/read_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace gyromode {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(GYROMODE_SOURCE_DIR) / "models" / "rotors";
constexpr double per_minute = std::numbers::pi / 30;

std::vector<double> positive(const Model& m, Index lowest) {
  ModesOptions options;
  options.lowest = lowest;
  const ModesResult r = m.modes(options);
  EXPECT_TRUE(r.is_complete()) << r.coverage.reason;
  std::vector<double> all = r.frequencies();
  std::erase_if(all, [](double w) { return w == 0; });
  return all;
}

TEST(ShippedRotors, KnownFrequenciesAndVerdicts) {
  int rotors = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const Model m = read_model(entry.path());
    EXPECT_EQ(m.frame, Frame::fixed);
    const std::vector<double> found = positive(m, std::max<Index>(4, static_cast<Index>(m.known.frequencies.size())));
    for (std::size_t k = 0; k < m.known.frequencies.size(); ++k) {
      const double digits = m.known.frequencies[k] < 130 && m.title.starts_with("Jeffcott") ? 3e-3 : 1e-7;  // a massless shaft
      EXPECT_NEAR(found[k], m.known.frequencies[k], digits * found[k]) << entry.path();
    }
    if (!m.known.stability.empty()) {
      EXPECT_EQ(to_string(m.stability().result.stability), m.known.stability) << entry.path();
    }
    ++rotors;
  }
  EXPECT_GE(rotors, 8);
}

// A disc on a massless cantilever: with f, g, h the deflection and slope of its end under unit force and moment, det[1
// − (ω²m, …)] in closed form: 12k(k − …); here by the 2 × 2 flexibility [L³/3, L²/2; L²/2, L]/EI in the rotating plane,
// I_dω² ∓ I_pΩω in the place of the moment of inertia.
TEST(ShippedRotors, OverhungDiscHasItsClosedForm) {
  const double l = 0.3, ei = 2.1e11 * std::numbers::pi / 64 * std::pow(0.03, 4), m = 12, ip = 0.12, id = 0.07, speed = 6000 * per_minute;
  const auto characteristic = [&](double w, double sense) {
    const double force = m * w * w, moment = id * w * w - sense * ip * speed * w;
    const double a = 1 - force * l * l * l / (3 * ei), b = -moment * l * l / (2 * ei), c = -force * l * l / (2 * ei),
                 d = 1 - moment * l / ei;
    return a * d - b * c;
  };
  const std::vector<double> found = positive(read_model(folder / "overhung_disc.toml"), 4);
  for (const double w : found) {
    if (w > 1e4) break;
    const double size = std::min(std::abs(characteristic(w, 1)), std::abs(characteristic(w, -1)));
    const double beside = std::min(std::abs(characteristic(1.001 * w, 1) - characteristic(w, 1)),
                                   std::abs(characteristic(1.001 * w, -1) - characteristic(w, -1)));
    EXPECT_LE(size, 1e-2 * beside) << w;  // within 1e-5 of the root: the shaft has some mass
  }
}

TEST(ShippedRotors, FreeShaftPrecessesAtTheRatioOfItsInertias) {
  const double squares = 0.06 * 0.06 + 0.04 * 0.04, polar = squares / 8, diametral = squares / 16 + 1.0 / 12;
  const std::vector<double> found = positive(read_model(folder / "free_shaft.toml"), 3);
  EXPECT_NEAR(found[0], 10000 * per_minute * polar / diametral, 1e-5 * found[0]);
}

TEST(ShippedRotors, MomentumWheelRocksAndNutates) {
  const double a = 0.09, b = 0.16 * 5000 * per_minute, c = 1e4, root = std::sqrt(b * b + 4 * a * c);
  const std::vector<double> found = positive(read_model(folder / "momentum_wheel.toml"), 4);
  EXPECT_NEAR(found[0], (root - b) / (2 * a), 1e-3 * found[0]);
  EXPECT_NEAR(found[1], std::sqrt(1e6 / 8), 1e-3 * found[1]);
  EXPECT_NEAR(found[3], (root + b) / (2 * a), 1e-3 * found[3]);
}

// A parameter of a part, of a material, of several parts at once.
TEST(ShippedRotors, NumbersOfPartsAreParameters) {
  const Model m = read_model(folder / "two_discs.toml");
  EXPECT_NEAR(m.body->parameter("disk[1].outer_diameter")->value, 0.35, 1e-15);
  EXPECT_EQ(m.body->parameter("material.steel.young")->value, 211e9);
  const Model stiff = m.with({{"bearing[*].kxx", 4e6}, {"bearing[*].kyy", 4e6}}), heavy = m.with({{"material.steel.density", 4 * 7810}}),
              still = m.with({{"speed", 0}});
  EXPECT_GT(positive(stiff, 1)[0], positive(m, 1)[0]);
  EXPECT_NEAR(positive(heavy.with({{"speed", 0}}), 1)[0], 0.5 * positive(still, 1)[0], 1e-9 * positive(still, 1)[0]);
  EXPECT_NEAR(positive(still, 2)[1], 86.65811, 1e-5);
}

}  // namespace
}  // namespace gyromode
