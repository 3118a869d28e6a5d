#include "gyromode/read/spacecraft_toml.h"

#include "gyromode/read/part_toml.h"
#include "gyromode/spacecraft/part_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gyromode::io {

namespace {

constexpr std::array<std::string_view, 10> spacecraft_keys{"kind", "title", "reference", "known", "parameters",
                                                           "spin", "body",  "cable",     "beam",  "spring_mass"};

bool upward(const TomlTable& t) {
  const std::vector<double> way = t.numbers("direction");
  if (way.size() != 3)
    t.fail(way.empty() ? "key 'direction' is missing: [0, 0, 1] or [0, 0, -1] was expected"
                       : "'direction' needs three numbers: [0, 0, 1] or [0, 0, -1]");
  if (way[0] != 0 || way[1] != 0 || std::abs(way[2]) != 1) {
    t.break_law("direction", fmt::format("'direction' of a beam must be [0, 0, 1] or [0, 0, -1]: it is [{:.6g}, {:.6g}, {:.6g}]; in any "
                                         "other direction the spin loads the boom along itself, "
                                         "which the exact field of this version does not have",
                                         way[0], way[1], way[2]));
  }
  return way[2] > 0;
}

Beam read_beam(const TomlTable& t) {
  const bool up = upward(t);
  Beam b = read_part<Beam>(t, {"direction"});
  b.upward = up;
  return b;
}

}  // namespace

Spacecraft read_spacecraft(const TomlTable& table) {
  table.allow_only(spacecraft_keys);
  const double spin = required(table, "spin", Dimension::frequency);
  const auto body = table.table("body");
  if (!body) table.fail("table [body] is missing: the rigid central body, with mass and inertia, was expected");
  std::vector<Cable> cables;
  for (const TomlTable& t : table.tables("cable")) cables.push_back(checked(t, read_part<Cable>(t)));
  std::vector<Beam> beams;
  for (const TomlTable& t : table.tables("beam")) beams.push_back(checked(t, read_beam(t)));
  std::vector<SpringMass> masses;
  for (const TomlTable& t : table.tables("spring_mass")) masses.push_back(checked(t, read_part<SpringMass>(t)));
  if (!(spin > 0)) {
    table.break_law("spin", fmt::format("'spin' must be above 0: it is {:.6g} rad/s{}", spin,
                                        spin < 0         ? " (for the other sense of rotation turn axis 3 around)"
                                        : cables.empty() ? ""
                                                         : ", and without it no cable is taut"));
  }
  const bool beyond_a_turn =
      std::any_of(cables.begin(), cables.end(), [](const Cable& c) { return std::abs(c.azimuth) > 2 * std::numbers::pi; });
  try {
    return Spacecraft(spin, checked(*body, read_part<Body>(*body)), std::move(cables), std::move(beams), std::move(masses));
  } catch (const LawBroken& e) {
    if (!beyond_a_turn || e.located()) throw;
    throw LawBroken(std::string(e.what()) + "; an azimuth is beyond a whole turn: a bare number is in rad, degrees are written \"90 deg\"");
  }
}

}  // namespace gyromode::io
