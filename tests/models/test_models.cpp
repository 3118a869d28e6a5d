// Every shipped model has the class, verdict and frequencies that it declares.
#include "gyromode/read/read_model.h"
#include "gyromode/models/spacecraft_model.h"
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

ModesResult modes_of(const Model& model) {
  ModesOptions options;
  if (!model.body->finite()) options.window.b = model.known.frequencies.back() * (1 + 1e-9);
  return model.modes(options);
}

std::string class_of(const Model& model, const ModesResult& r) {
  if (model.body->transcendental()) return "transcendental";
  return std::string(to_string(r.structure.system_class()));
}

TEST_P(ShippedModel, HasItsKnownValues) {
  const Model model = read_model(GetParam());
  EXPECT_FALSE(model.reference.empty());
  ASSERT_FALSE(model.known.frequencies.empty());
  const ModesResult r = modes_of(model);
  EXPECT_EQ(to_string(r.stability), model.known.stability);
  EXPECT_EQ(class_of(model, r), model.known.system_class);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
  ASSERT_EQ(r.modes.size(), model.known.frequencies.size());
  for (std::size_t i = 0; i < r.modes.size(); ++i)
    EXPECT_NEAR(r.modes[i].omega, model.known.frequencies[i], 2e-13 * model.known.frequencies[i]);
}

// What the file declares is no echo of the exact solver alone: finite elements of high degree have it, too.
TEST_P(ShippedModel, SpacecraftAgreesWithItsTwin) {
  const Model model = read_model(GetParam());
  const auto* exact = dynamic_cast<const SpacecraftModel*>(model.body.get());
  if (!exact) return;
  ModesOptions options;
  options.window.b = model.known.frequencies.back() * (1 + 1e-6);
  const ModesResult twin = find_modes(exact->spacecraft(), Mesh{1, 24}, options);
  ASSERT_GE(twin.modes.size(), model.known.frequencies.size());
  for (std::size_t i = 0; i < model.known.frequencies.size(); ++i)
    EXPECT_NEAR(twin.modes[i].omega, model.known.frequencies[i], 3e-7 * model.known.frequencies[i]) << i;
}

INSTANTIATE_TEST_SUITE_P(All, ShippedModel, testing::ValuesIn(shipped()), [](const auto& file) { return file.param.stem().string(); });

}  // namespace
}  // namespace gyromode
