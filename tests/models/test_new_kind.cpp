// A kind of model that the library does not know, a plane double pendulum in fixed axes, made here: it answers the
// verbs and is written as a document like any other.
#include "gyromode/base/error.h"
#include "gyromode/write/document.h"
#include "gyromode/models/matrices.h"
#include "gyromode/models/model.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace gyromode {
namespace {

// Two equal masses on strings of length l, angles small: ω² = (2 ± √2) g/l.
class DoublePendulum : public ModelKind {
 public:
  explicit DoublePendulum(double gravity_over_length)
      : system_(Matrix{{2, 1}, {1, 1}}, Matrix::Zero(2, 2), gravity_over_length * Matrix{{2, 0}, {0, 1}}, {"upper", "lower"}) {}

  Index size() const override { return 2; }
  const Labels& labels() const override { return system_.labels(); }
  std::string_view in_words() const override { return "double pendulum, fixed axes"; }
  ModesResult modes(const ModesOptions& options) const override { return find_modes(system_, options); }
  CountResult count(const Window& window) const override { return count_modes(system_, window); }
  StructureReport structure(std::optional<double> at) const override { return MatricesModel(system_).structure(at); }

 private:
  System system_;
};

Model pendulum() { return Model(std::make_shared<DoublePendulum>(10), "double_pendulum"); }

TEST(NewKind, AnswersTheVerbs) {
  const Model m = pendulum();
  const ModesResult r = m.modes({});
  ASSERT_EQ(r.modes.size(), 2u);
  EXPECT_NEAR(r.modes[0].omega, std::sqrt(10 * (2 - std::sqrt(2.0))), 1e-14);
  EXPECT_EQ(m.count({0, 3}).count, 1);
  EXPECT_EQ(m.stability().result.stability, Stability::stable);
}

TEST(NewKind, IsWrittenLikeAnyOther) {
  const Model m = pendulum();
  const auto modes = nlohmann::json::parse(document(m, m.modes({}), {}, Format::json));
  EXPECT_EQ(modes["model"]["kind"], "double_pendulum");
  EXPECT_EQ(modes["coverage"]["status"], "complete");
  const auto structure = nlohmann::json::parse(document(m, m.structure(2.0), {}, Format::json));
  EXPECT_EQ(structure["checks"]["mass_trace"], 3);
  EXPECT_NE(document(m, m.modes({}), {}, Format::table).find("double pendulum, fixed axes"), std::string::npos);
}

TEST(NewKind, SaysWhatItHasNoAnswerTo) {
  const Model m = pendulum();
  EXPECT_THROW(m.body->response({State::rest(2), {}, {}, Vector::Zero(1), false, {}}), NotApplicable);
  EXPECT_THROW(m.body->frequency_response({Vector::Zero(2), Vector::Zero(1), {}}), NotApplicable);
  EXPECT_THROW(m.body->discretised(std::nullopt), NotApplicable);
  EXPECT_THROW(m.body->without_couplings(0.1), NotApplicable);
}

}  // namespace
}  // namespace gyromode
