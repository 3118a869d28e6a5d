// Every shipped model has the class, verdict and frequencies that it declares.
#include "gyromode/io/model.h"
#include "gyromode/modes/modes.h"

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

TEST_P(ShippedModel, HasItsKnownValues) {
  const io::Model model = io::read_model(GetParam());
  EXPECT_FALSE(model.reference.empty());
  ASSERT_FALSE(model.known.frequencies.empty());
  const ModesResult r = std::visit([](const auto& system) { return find_modes(system); }, model.system);
  EXPECT_EQ(word(r.stability), model.known.stability);
  EXPECT_EQ(r.structure.system_class() == SystemClass::quadrature ? "quadrature" : "general", model.known.system_class);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
  ASSERT_EQ(r.modes.size(), model.known.frequencies.size());
  for (std::size_t i = 0; i < r.modes.size(); ++i) EXPECT_NEAR(r.modes[i].omega, model.known.frequencies[i], 2e-13 * model.known.frequencies[i]);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedModel, testing::ValuesIn(shipped()), [](const auto& file) { return file.param.stem().string(); });

}  // namespace
}  // namespace gyromode
