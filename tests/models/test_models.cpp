// Every shipped model has the class, verdict and frequencies that it declares.
#include "gyromode/base/error.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/read/read_model.h"
#include "gyromode/models/spacecraft_model.h"
#include "gyromode/modes/modes.h"
#include "gyromode/modes/discrete.h"
#include "gyromode/modes/spacecraft.h"

#include <gtest/gtest.h>

#include <sstream>

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

// Built in code as in the file: the same answers.
TEST(ModelInCode, IsThatOfTheFile) {
  const Model file = read_model(std::filesystem::path(GYROMODE_SOURCE_DIR) / "models/three_springs.toml");
  const System& system = *file.body->second_order();
  const Model code(system);
  EXPECT_EQ(code.modes().frequencies(), file.modes().frequencies());
  EXPECT_EQ(code.kind, file.kind);
  EXPECT_TRUE(code.modes().is_complete());
  EXPECT_EQ(code.count({0, 600}).count, file.count({0, 600}).count);
  const double spin = *file.spin;
  EXPECT_EQ(file.with({{"spin", 2 * spin}}).spin, 2 * spin);
  EXPECT_EQ(file.with({{"spin", 2 * spin}}).with({{"spin", spin}}).modes().frequencies(), file.modes().frequencies());
  EXPECT_TRUE(file.with({{"spin", 2 * spin}}).known.frequencies.empty());  // what the file declares is of its own spin
  EXPECT_TRUE(code.without_couplings(0.01).ignored.has_value());
}

TEST(ModelInCode, ShapesAsOneBlock) {
  const Model m = read_model(std::filesystem::path(GYROMODE_SOURCE_DIR) / "models/wiresaw.toml");
  ModesOptions options;
  EXPECT_THROW(m.modes(options).shapes(), InvalidArgument);
  options.shapes = true;
  const ModesResult r = m.modes(options);
  ASSERT_EQ(r.shapes().cols(), static_cast<Index>(r.modes.size()));
  for (std::size_t k = 0; k < r.modes.size(); ++k) EXPECT_EQ(ComplexVector(r.shapes().col(static_cast<Index>(k))), r.modes[k].shape);
  std::ostringstream text;
  text << r;
  EXPECT_NE(text.str().find("stable; complete: found " + std::to_string(r.modes.size()) + ", counted"), std::string::npos) << text.str();
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
