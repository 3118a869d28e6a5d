// Shares of energy: they sum to 1 for every kind, and are what closed forms say.
#include "gyromode/models/model.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/models/rotor_model.h"
#include "gyromode/read/read_model.h"
#include "support/random_rotor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

namespace gyromode {
namespace {

const std::filesystem::path models = std::filesystem::path(GYROMODE_SOURCE_DIR) / "models";

ModesResult with_shapes(const Model& m) {
  ModesOptions o;
  o.shapes = true;
  if (!m.body->finite()) o.lowest = 8;
  return m.modes(o);
}

void expect_sums(const Model& m, const std::string& name) {
  const ModesResult r = with_shapes(m);
  for (const Mode& mode : r.modes) {
    const auto shares = m.body->energy_shares(mode, r.outlines);
    if (shares.empty()) continue;
    double kinetic = 0, strain = 0;
    for (const EnergyShare& s : shares) {
      kinetic += s.kinetic;
      strain += s.strain;
    }
    EXPECT_NEAR(kinetic, 1, 1e-12) << name << " " << mode.omega;
    if (!std::isnan(strain)) {
      EXPECT_NEAR(strain, 1, 1e-12) << name << " " << mode.omega;
    }
  }
}

TEST(EnergyShares, SumToOneForEveryKind) {
  int seen = 0;
  for (const char* folder : {"", "rotors"}) {
    for (const auto& file : std::filesystem::directory_iterator(models / folder)) {
      if (file.path().extension() != ".toml") continue;
      expect_sums(read_model(file.path()), file.path().filename());
      ++seen;
    }
  }
  EXPECT_GT(seen, 20);
  support::Source source{std::mt19937_64(3)};
  for (int draw = 0; draw < 30; ++draw)
    expect_sums(Model(std::make_shared<RotorModel>(Rotor(support::random_rotor(source)))), std::to_string(draw));
}

// Two masses on springs: the kinetic energy of each mass, and strain by rows of K.
TEST(EnergyShares, OfTwoMassesAreTheirs) {
  const Matrix m{{1, 0}, {0, 3}}, k{{5, -2}, {-2, 4}};
  const Model model(System(m, Matrix::Zero(2, 2), k));
  const ModesResult r = with_shapes(model);
  for (const Mode& mode : r.modes) {
    const Vector x = mode.shape.real();
    const auto shares = model.body->energy_shares(mode, {});
    const double kinetic = x(0) * x(0) + 3 * x(1) * x(1);
    EXPECT_NEAR(shares[0].kinetic, x(0) * x(0) / kinetic, 1e-14);
    EXPECT_NEAR(shares[1].strain, x(1) * (4 * x(1) - 2 * x(0)) / (mode.omega * mode.omega * kinetic), 1e-13);
  }
}

// A Jeffcott rotor: the disc has nearly all the kinetic energy of its lowest modes, the shaft nearly all the strain.
TEST(EnergyShares, OfAJeffcottRotorAreInTheDiscAndTheShaft) {
  const Model model = read_model(models / "rotors" / "jeffcott.toml");
  const ModesResult r = with_shapes(model);
  double disc = 0, shaft = 0;
  for (const EnergyShare& s : model.body->energy_shares(r.modes.front(), r.outlines)) {
    if (s.part.starts_with("disk")) disc += s.kinetic;
    if (s.part.starts_with("shaft")) shaft += s.strain;
  }
  EXPECT_GT(disc, 0.9);
  EXPECT_GT(shaft, 0.9);
}

// Forward of GEOS: where wires alone move the body has nothing.
TEST(EnergyShares, OfASpacecraftAreInItsParts) {
  const Model model = read_model(models / "geos.toml");
  const ModesResult r = with_shapes(model);
  for (const Mode& mode : r.modes) {
    if (mode.kind == ModeKind::vibration) {
      const auto shares = model.body->energy_shares(mode, r.outlines);
      ASSERT_EQ(shares.size(), 3U);
      EXPECT_NEAR(shares[1].kinetic, shares[2].kinetic, 1e-9);  // two equal wires
      EXPECT_GT(shares[1].kinetic, 0);
    }
  }
}

}  // namespace
}  // namespace gyromode
