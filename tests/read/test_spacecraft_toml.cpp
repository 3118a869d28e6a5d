// Models of kind "spacecraft": values and units as read, and one message for each thing that can be wrong, with its
// place.
#include "gyromode/base/error.h"
#include "gyromode/read/read_model.h"
#include "gyromode/read/toml_table.h"
#include "gyromode/models/spacecraft_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gyromode::io {
namespace {

const std::string head = "kind = 'spacecraft'\nspin = '10 rpm'\n[body]\nmass = 272.4\ninertia = [85, 100, 120]\n";
const std::string pair_of_cables =
    "[[cable]]\nazimuth = '90 deg'\nradius = '825 mm'\nheight = -0.25\nlength = 20\nline_density = '30 g/m'\n"
    "[[cable]]\nazimuth = '270 deg'\nradius = '825 mm'\nheight = -0.25\nlength = 20\nline_density = '30 g/m'\n";

Spacecraft read(const std::string& text) {
  return dynamic_cast<const SpacecraftModel&>(*parse_model(text, "craft.toml").body).spacecraft();
}

template <class Error>
std::string message(const std::string& text) {
  try {
    parse_model(text, "craft.toml");
  } catch (const Error& e) {
    return e.what();
  }
  return "accepted";
}
std::string unreadable(const std::string& text) { return message<Unreadable>(text); }
std::string unchecked(const std::string& text) { return message<LawBroken>(text); }

TEST(SpacecraftToml, ValuesAndUnits) {
  const Spacecraft s = read(head + pair_of_cables +
                            "[[beam]]\nroot = [0, 0, '50 cm']\ndirection = [0, 0, -1]\nlength = 7.5\nline_density = "
                            "0.06\nbending_stiffness = [20, '16 N m²']\ntip_mass = '50 g'\n"
                            "[[spring_mass]]\nposition = [0, 0, 1]\nmass = 2\nstiffness = [50, '0.06 N/mm', inf]\n");
  EXPECT_DOUBLE_EQ(s.spin(), std::numbers::pi / 3);
  ASSERT_EQ(s.cables().size(), 2u);
  EXPECT_DOUBLE_EQ(s.cables()[1].azimuth, 1.5 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(s.cables()[0].radius, 0.825);
  EXPECT_DOUBLE_EQ(s.cables()[0].line_density, 0.03);
  EXPECT_EQ(s.cables()[0].tip_mass, 0);
  ASSERT_EQ(s.beams().size(), 1u);
  EXPECT_FALSE(s.beams()[0].upward);
  EXPECT_DOUBLE_EQ(s.beams()[0].root_height, 0.5);
  EXPECT_EQ(s.beams()[0].bending_stiffness[1], 16);
  ASSERT_EQ(s.masses().size(), 1u);
  EXPECT_DOUBLE_EQ(s.masses()[0].stiffness(1), 60);
  EXPECT_TRUE(std::isinf(s.masses()[0].stiffness(2)));
  const Model model = parse_model(head, "craft.toml");
  EXPECT_EQ(model.kind, "spacecraft");
  EXPECT_EQ(model.size(), 6);
  EXPECT_EQ(model.labels().front(), "zeta1");
  EXPECT_EQ(read("kind = 'spacecraft'\nspin = 1\n[body]\nmass = 1\ninertia = [[2, 0.1, 0], [0.1, 3, 0], [0, 0, 4]]\n").body().inertia(0, 1),
            0.1);
}

TEST(SpacecraftToml, MissingKeys) {
  EXPECT_EQ(unreadable("kind = 'spacecraft'\n[body]\nmass = 1\ninertia = [1, 1, 1]\n").substr(0, 36),
            "craft.toml:1: key 'spin' is missing:");
  EXPECT_EQ(unreadable("kind = 'spacecraft'\nspin = 1\n"),
            "craft.toml:1: table [body] is missing: the rigid central body, with mass and inertia, was expected");
  EXPECT_EQ(unreadable("kind = 'spacecraft'\nspin = 1\n[body]\nmass = 1\n").substr(0, 39), "craft.toml:3: key 'inertia' is missing:");
  EXPECT_EQ(unreadable(head + "[[cable]]\nazimuth = 0\nradius = 1\nline_density = 1\n"),
            "craft.toml:6: key 'length' is missing: a number in m, or one with a unit: m, mm, cm, km was expected");
  EXPECT_EQ(unreadable(head + "[[beam]]\nroot = [0, 0, 1]\nlength = 1\n"),
            "craft.toml:6: key 'direction' is missing: [0, 0, 1] or [0, 0, -1] was expected");
}

TEST(SpacecraftToml, WrongTypesUnitsAndNames) {
  EXPECT_EQ(unreadable(head + "[[cable]]\nazimut = 0\n"), "craft.toml:7:1: key 'azimut' is not known here: did you mean 'azimuth'?");
  EXPECT_EQ(unreadable(head + "[[cables]]\nazimuth = 0\n"), "craft.toml:6:3: key 'cables' is not known here: did you mean 'cable'?");
  EXPECT_EQ(unreadable(head + "[[cable]]\nazimuth = '90 dog'\n"),
            "craft.toml:7:11: 'azimuth' = \"90 dog\": a number in rad, or one with a unit: rad, deg, ° was expected");
  EXPECT_EQ(unreadable(head + "[[cable]]\nazimuth = 0\nradius = '3 kg'\n"),
            "craft.toml:8:10: 'radius' = \"3 kg\": a number in m, or one with a unit: m, mm, cm, km was expected");
  EXPECT_EQ(unreadable(head + "[[cable]]\nazimuth = 0\nradius = nan\n"), "craft.toml:8:10: 'radius' is nan: a finite number was expected");
  EXPECT_EQ(unreadable(head + "[cable]\nazimuth = 0\n"), "craft.toml:6:1: 'cable' is a table: tables [[cable]] were expected");
  EXPECT_EQ(unreadable("kind = 'spacecraft'\nspin = 1\n[body]\nmass = 1\ninertia = [1, 2]\n"),
            "craft.toml:5:11: 'inertia' has 2 values: 3 were expected");
  EXPECT_EQ(unreadable("kind = 'spacecraft'\nspin = 1\n[body]\nmass = 1\ninertia = [[1, 2]]\n"),
            "craft.toml:5:11: 'inertia' is 1 × 2: 3 values or 3 × 3 were expected");
  EXPECT_EQ(unreadable(head + "[[spring_mass]]\nposition = [0, inf, 1]\nmass = 1\nstiffness = [1, 1, 1]\n"),
            "craft.toml:7:16: value 2 of 'position' is inf: a finite number was expected");
}

TEST(SpacecraftToml, LawsAreBrokenAtTheirPlace) {
  const std::string cable = "[[cable]]\nazimuth = 0\nradius = 0.5\nlength = ";
  EXPECT_EQ(unchecked(head + cable + "-20\nline_density = 1\n"), "craft.toml:9:10: 'length' must be above 0: it is -20 m");
  EXPECT_EQ(unchecked(head + cable + "20\nline_density = -1\n"), "craft.toml:10:16: 'line_density' must be above 0: it is -1 kg/m");
  EXPECT_EQ(unchecked("kind = 'spacecraft'\nspin = 0\n[body]\nmass = 1\ninertia = [2, 3, 4]\n" + pair_of_cables),
            "craft.toml:2:8: 'spin' must be above 0: it is 0 rad/s, and without it no cable is taut");
  EXPECT_EQ(
      unchecked("kind = 'spacecraft'\nspin = 1\n[body]\nmass = 1\ninertia = [1, 2, 4]\n"),
      "craft.toml:5:11: 'inertia' must obey the triangle inequality, no principal moment above the sum of the others: 4 > 1 + 2 kg m²");
  const std::string beam = "[[beam]]\nlength = 1\nline_density = 1\nbending_stiffness = [1, 1]\n";
  EXPECT_NE(unchecked(head + beam + "root = [0, 0, 1]\ndirection = [1, 0, 0]\n")
                .find("craft.toml:11:13: 'direction' of a beam must be [0, 0, 1] or [0, 0, -1]: it is [1, 0, 0]"),
            std::string::npos);
  EXPECT_NE(
      unchecked(head + beam + "root = [0.1, 0, 1]\ndirection = [0, 0, 1]\n").find("craft.toml:10:8: 'root' of a beam must be on axis 3"),
      std::string::npos);
  EXPECT_EQ(unchecked(head + pair_of_cables), "accepted");
  EXPECT_NE(unchecked(head + pair_of_cables + "[[cable]]\nazimuth = 0\nradius = 1\nlength = 10\nline_density = 0.1\n")
                .find("leaves a centrifugal force of (6.57974, "),
            std::string::npos);
}

}  // namespace
}  // namespace gyromode::io
