#include "gyromode/read/spacecraft_toml.h"

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
double required(const TomlTable& t, std::string_view key, Dimension d) {
  const auto value = t.quantity(key, d);
  if (!value) t.fail(fmt::format("key '{}' is missing: {} was expected", key, form_of(d)));
  return *value;
}

template <class Part>
Part checked(const TomlTable& t, Part part) {
  if (const auto broken = broken_law(part)) t.break_law(broken->key, broken->law);
  return part;
}

// Only booms along the spin axis: there the centrifugal force does not load them.
double height_on_axis_3(const TomlTable& t, std::string_view key, Dimension dimension) {
  const std::vector<double> at = t.quantities(key, dimension, 3);
  if (at.empty()) t.fail(fmt::format("key '{}' is missing: three values were expected, each {}", key, form_of(dimension)));
  if (at[0] != 0 || at[1] != 0) {
    t.break_law(key, fmt::format("'{}' of a beam must be on axis 3, [0, 0, z]: it is [{:.6g}, {:.6g}, {:.6g}]; off the axis the "
                                 "centrifugal force bends a boom while it spins steadily",
                                 key, at[0], at[1], at[2]));
  }
  return at[2];
}

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

void read_several(const TomlTable& t, const NumberKey& k, std::span<double> to) {
  const std::vector<double> values = t.quantities(k.key, k.dimension, to.size(), k.form == NumberKey::Form::several_or_infinite);
  if (values.empty())
    t.fail(fmt::format("key '{}' is missing: {} values were expected, each {}", k.key, to.size() == 2 ? "two" : "three",
                       form_of(k.dimension)));
  std::copy(values.begin(), values.end(), to.begin());
}

// The numbers of a part from its table, which has no other keys but `more`.
template <class Part>
Part read_part(const TomlTable& t, std::initializer_list<std::string_view> more = {}) {
  Part part;
  std::vector<std::string_view> keys(more);
  each_number(part, [&](const NumberKey& k, std::span<double>) { keys.push_back(k.key); });
  t.allow_only(keys);
  each_number(part, [&](const NumberKey& k, std::span<double> to) {
    switch (k.form) {
      case NumberKey::Form::one: to[0] = required(t, k.key, k.dimension); break;
      case NumberKey::Form::one_or_zero: to[0] = t.quantity(k.key, k.dimension).value_or(0); break;
      case NumberKey::Form::on_axis_3: to[0] = height_on_axis_3(t, k.key, k.dimension); break;
      case NumberKey::Form::several:
      case NumberKey::Form::several_or_infinite: read_several(t, k, to); break;
      case NumberKey::Form::symmetric: {
        const auto inertia = t.diagonal_or_matrix(k.key, k.dimension, 3);
        if (!inertia) t.fail(fmt::format("key '{}' is missing: three principal moments in kg m², or a 3 × 3 matrix, were expected", k.key));
        Eigen::Map<Matrix>(to.data(), 3, 3) = *inertia;
      }
    }
  });
  return part;
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
