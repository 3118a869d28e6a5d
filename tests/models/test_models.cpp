// Every shipped model has the class, verdict and frequencies that it declares.
#include "gyromode/io/model.h"
#include "gyromode/modes/modes.h"
#include "gyromode/modes/discrete.h"
#include "gyromode/modes/spacecraft.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace gyromode {
namespace {

std::vector<std::filesystem::path> shipped() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(GYROMODE_SOURCE_DIR) / "models")) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  return files;
}

class ShippedModel : public testing::TestWithParam<std::filesystem::path> {};

ModesResult modes_of(const System& system, const io::KnownValues&) { return find_modes(system); }
ModesResult modes_of(const FirstOrderSystem& system, const io::KnownValues&) { return find_modes(system); }
ModesResult modes_of(const Spacecraft& spacecraft, const io::KnownValues& known) {
  ModesOptions options;
  options.window.b = known.frequencies.back() * (1 + 1e-9);
  return find_modes(spacecraft, options);
}

std::string class_of(const io::Model& model, const ModesResult& r) {
  if (std::holds_alternative<Spacecraft>(model.system)) return "transcendental";
  return std::string(word(r.structure.system_class()));
}

TEST_P(ShippedModel, HasItsKnownValues) {
  const io::Model model = io::read_model(GetParam());
  EXPECT_FALSE(model.reference.empty());
  ASSERT_FALSE(model.known.frequencies.empty());
  const ModesResult r = std::visit([&](const auto& system) { return modes_of(system, model.known); }, model.system);
  EXPECT_EQ(word(r.stability), model.known.stability);
  EXPECT_EQ(class_of(model, r), model.known.system_class);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
  ASSERT_EQ(r.modes.size(), model.known.frequencies.size());
  for (std::size_t i = 0; i < r.modes.size(); ++i) EXPECT_NEAR(r.modes[i].omega, model.known.frequencies[i], 2e-13 * model.known.frequencies[i]);
}

// What the file declares is no echo of the exact solver alone: finite elements of high degree have it, too.
TEST_P(ShippedModel, SpacecraftAgreesWithItsTwin) {
  const io::Model model = io::read_model(GetParam());
  const auto* spacecraft = std::get_if<Spacecraft>(&model.system);
  if (!spacecraft) return;
  ModesOptions options;
  options.window.b = model.known.frequencies.back() * (1 + 1e-6);
  const ModesResult twin = find_modes(*spacecraft, Mesh{1, 24}, options);
  ASSERT_GE(twin.modes.size(), model.known.frequencies.size());
  for (std::size_t i = 0; i < model.known.frequencies.size(); ++i) EXPECT_NEAR(twin.modes[i].omega, model.known.frequencies[i], 3e-7 * model.known.frequencies[i]) << i;
}

INSTANTIATE_TEST_SUITE_P(All, ShippedModel, testing::ValuesIn(shipped()), [](const auto& file) { return file.param.stem().string(); });

}  // namespace
}  // namespace gyromode
