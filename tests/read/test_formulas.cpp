// Formulas of named parameters in model files: values, order, what is refused, and models with other values of them.
#include "gyromode/base/error.h"
#include "gyromode/models/model.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/read/formulas.h"
#include "gyromode/read/read_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace gyromode {
namespace {

using io::Formulas;

Formulas with_mu() {
  Formulas f;
  EXPECT_FALSE(f.add("mu", 0.25, std::nullopt));
  return f;
}

TEST(Formulas, Values) {
  const Formulas f = with_mu();
  const std::pair<const char*, double> cases[] = {{"1 - 2*mu", 0.5},
                                                  {"-mu", -0.25},
                                                  {"2^3^2", 512},
                                                  {"-2^2", -4},
                                                  {"sqrt(mu)", 0.5},
                                                  {"2*pi", 2 * std::numbers::pi},
                                                  {"atan2(1, 1)", std::numbers::pi / 4},
                                                  {"min(3, mu, 1)", 0.25},
                                                  {"max(3, mu)", 3},
                                                  {"1.5e-3", 1.5e-3},
                                                  {"(1 + mu)/(1 - mu)", 1.25 / 0.75},
                                                  {"log(exp(1))", 1},
                                                  {"abs(-mu)", 0.25}};
  for (const auto& [text, value] : cases) {
    const auto found = f.evaluate(text);
    EXPECT_FALSE(found.fault) << text << ": " << found.fault->message;
    EXPECT_DOUBLE_EQ(found.value, value) << text;
  }
}

TEST(Formulas, WhatIsNoneIsNamed) {
  const Formulas f = with_mu();
  const std::pair<const char*, const char*> cases[] = {{"1 - nu", "'nu' is no parameter: there are mu"},
                                                       {"mu = 3", "'=' has no place"},
                                                       {"mu > 1 ? 2 : 3", "has no place"},
                                                       {"1/0", "is infinite"},
                                                       {"sqrt(-1)", "is no real number"},
                                                       {"3,5", "holds a comma"},
                                                       {"max(1,2), 4", "holds a comma"},
                                                       {"mu**2", "powers are written a^2"},
                                                       {"2mu", "products are written 2*a"},
                                                       {"2 *", "is no formula"},
                                                       {"", "is no formula"},
                                                       {"system(1)", "no"},
                                                       {"(1", "is no formula"}};
  for (const auto& [text, words] : cases) {
    const auto found = f.evaluate(text);
    ASSERT_TRUE(found.fault) << text;
    EXPECT_NE(found.fault->message.find(words), std::string::npos) << text << ": " << found.fault->message;
  }
  EXPECT_TRUE(f.evaluate(std::string(2000, '1')).fault);
  Formulas g;
  for (const char* name : {"", "2a", "a b", "sin", "pi", "ä"}) EXPECT_TRUE(g.add(name, 1, std::nullopt)) << name;
}

// The triangular points: flutter above Routh's mass ratio, 27 μ(1 − μ) = 1.
const char* const libration = R"toml(
kind = "matrices"
mass = [1, 1]
gyroscopic = [[0, -2], [2, 0]]
stiffness = [[-0.75, "-c"], ["-c", -2.25]]
[parameters]
mu = 0.01
c = "3*sqrt(3)/4*(1 - 2*mu)"
)toml";

TEST(Formulas, ModelsOfThem) {
  const Model at = parse_model(libration, "L4.toml");
  EXPECT_EQ(at.modes().stability, Stability::gyroscopically_stabilised);
  EXPECT_EQ(at.parameters().front().key, "mu");
  EXPECT_EQ(at.with({{"mu", 0.05}}).modes().stability, Stability::unstable);
  EXPECT_EQ(at.with({{"mu", 0.05}}).with({{"mu", 0.01}}).modes().frequencies(), at.modes().frequencies());
  EXPECT_DOUBLE_EQ(at.with({{"mu", 0.05}}).body->parameter("c")->value, 3 * std::sqrt(3.0) / 4 * 0.9);  // it has followed
  EXPECT_EQ(at.with({{"c", 0}}).body->second_order()->stiffness()(0, 1), 0);                            // or is given itself
  EXPECT_EQ(at.with({{"mu", 0.05}, {"stiffness[0][0]", -1}}).body->second_order()->stiffness()(0, 0), -1);
  EXPECT_THROW(at.with({{"mu", 0.05}, {"mu", 0.06}}), InvalidArgument);
  EXPECT_THROW(at.with({{"nu", 0.05}}), InvalidArgument);
  const StabilityMap map = at.stability_over({{"mu", {0.01, 0.02, 0.03, 0.04, 0.05}}});
  ASSERT_EQ(map.critical.size(), 1U);
  EXPECT_NEAR(map.critical.front().value, (1 - std::sqrt(23.0 / 27)) / 2, 1e-14);
}

TEST(Formulas, OfSpacecraftWithUnits) {
  const std::string text = R"toml(
kind = "spacecraft"
spin = "rate"
[parameters]
rate = "10 rpm"
reach = "20 m"
[body]
mass = 260
inertia = [90, 110, 150]
[[cable]]
azimuth = "0 deg"
radius = 0.7
height = 0
length = "reach"
line_density = "1.65 g/m"
[[cable]]
azimuth = "pi"
radius = 0.7
height = 0
length = "reach"
line_density = "1.65 g/m"
)toml";
  const Model craft = parse_model(text, "craft.toml");
  EXPECT_EQ(craft.spin, std::numbers::pi / 3);
  EXPECT_EQ(craft.body->parameter("cable[1].length")->value, 20);
  const Model longer = craft.with({{"reach", 25}});
  EXPECT_EQ(longer.body->parameter("cable[0].length")->value, 25);
  EXPECT_EQ(longer.body->parameter("cable[1].length")->value, 25);
  EXPECT_EQ(craft.body->parameter("rate")->dimension, Dimension::frequency);
}

std::string refusal(const std::string& text) {
  try {
    parse_model(text, "m.toml");
  } catch (const Error& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Formulas, RefusalsNameThePlace) {
  const std::string start = "kind = \"matrices\"\nmass = [[\"m\"]]\n";
  EXPECT_EQ(refusal(start), "m.toml:2:10: entry (1,1) of 'mass' = \"m\": 'm' is no parameter; [parameters] are none");
  EXPECT_EQ(refusal(start + "parameters = 3\n"), "m.toml:3:14: 'parameters' is a number: a table [parameters] was expected");
  EXPECT_EQ(refusal(start + "[parameters]\nm = \"2*n\"\nn = 1\n"),
            "m.toml:4:5: parameter 'm' = \"2*n\": 'n' is no parameter; [parameters] are none");
  EXPECT_EQ(refusal(start + "[parameters]\nm = true\n"), "m.toml:4:5: parameter 'm' is true or false: a number was expected");
  EXPECT_EQ(refusal(start + "[parameters]\nsin = 1\n"), "m.toml:4:7: parameter 'sin' is a function: another name was expected");
}

}  // namespace
}  // namespace gyromode
