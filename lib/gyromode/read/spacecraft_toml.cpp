#include "gyromode/read/spacecraft_toml.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace gyromode::io {

namespace {

constexpr std::array<std::string_view, 9> spacecraft_keys{"kind", "title", "reference", "known", "spin", "body", "cable", "beam", "spring_mass"};
constexpr std::array<std::string_view, 2> body_keys{"mass", "inertia"};
constexpr std::array<std::string_view, 6> cable_keys{"azimuth", "radius", "height", "length", "line_density", "tip_mass"};
constexpr std::array<std::string_view, 6> beam_keys{"root", "direction", "length", "line_density", "bending_stiffness", "tip_mass"};
constexpr std::array<std::string_view, 3> spring_mass_keys{"position", "mass", "stiffness"};

double required(const TomlTable& t, std::string_view key, Dimension d) {
  const auto value = t.quantity(key, d);
  if (!value) t.fail(fmt::format("key '{}' is missing: {} was expected", key, form_of(d)));
  return *value;
}

Eigen::Vector3d required_vector(const TomlTable& t, std::string_view key, Dimension d, bool infinite = false) {
  const std::vector<double> v = t.quantities(key, d, 3, infinite);
  if (v.empty()) t.fail(fmt::format("key '{}' is missing: three values were expected, each {}", key, form_of(d)));
  return {v[0], v[1], v[2]};
}

template <class Part>
Part checked(const TomlTable& t, Part part) {
  if (const auto broken = broken_law(part)) t.break_law(broken->key, broken->law);
  return part;
}

Body read_body(const TomlTable& t) {
  t.allow_only(body_keys);
  const auto inertia = t.diagonal_or_matrix("inertia", Dimension::inertia, 3);
  if (!inertia) t.fail("key 'inertia' is missing: three principal moments in kg m², or a 3 × 3 matrix, were expected");
  return checked(t, Body{required(t, "mass", Dimension::mass), *inertia});
}

Cable read_cable(const TomlTable& t) {
  t.allow_only(cable_keys);
  Cable c;
  c.azimuth = required(t, "azimuth", Dimension::angle);
  c.radius = required(t, "radius", Dimension::length);
  c.height = t.quantity("height", Dimension::length).value_or(0);
  c.length = required(t, "length", Dimension::length);
  c.line_density = required(t, "line_density", Dimension::line_density);
  c.tip_mass = t.quantity("tip_mass", Dimension::mass).value_or(0);
  return checked(t, c);
}

// Only booms along the spin axis: there the centrifugal force does not load them.
Beam read_beam(const TomlTable& t) {
  t.allow_only(beam_keys);
  Beam b;
  const Eigen::Vector3d root = required_vector(t, "root", Dimension::length);
  if (root(0) != 0 || root(1) != 0) {
    t.break_law("root", fmt::format("'root' of a beam must be on axis 3, [0, 0, z]: it is [{:.6g}, {:.6g}, {:.6g}]; off the axis the centrifugal force bends a boom while it spins steadily", root(0),
                                    root(1), root(2)));
  }
  b.root_height = root(2);
  const std::vector<double> way = t.numbers("direction");
  if (way.size() != 3) t.fail(way.empty() ? "key 'direction' is missing: [0, 0, 1] or [0, 0, -1] was expected" : "'direction' needs three numbers: [0, 0, 1] or [0, 0, -1]");
  if (way[0] != 0 || way[1] != 0 || std::abs(way[2]) != 1) {
    t.break_law("direction", fmt::format("'direction' of a beam must be [0, 0, 1] or [0, 0, -1]: it is [{:.6g}, {:.6g}, {:.6g}]; in any other direction the spin loads the boom along itself, "
                                         "which the exact field of this version does not have",
                                         way[0], way[1], way[2]));
  }
  b.upward = way[2] > 0;
  b.length = required(t, "length", Dimension::length);
  b.line_density = required(t, "line_density", Dimension::line_density);
  const std::vector<double> stiffness = t.quantities("bending_stiffness", Dimension::bending_stiffness, 2);
  if (stiffness.empty()) t.fail("key 'bending_stiffness' is missing: two values in N m² were expected, for motion along axes 1 and 2");
  b.bending_stiffness[0] = stiffness[0];
  b.bending_stiffness[1] = stiffness[1];
  b.tip_mass = t.quantity("tip_mass", Dimension::mass).value_or(0);
  return checked(t, b);
}

SpringMass read_spring_mass(const TomlTable& t) {
  t.allow_only(spring_mass_keys);
  return checked(t, SpringMass{required_vector(t, "position", Dimension::length), required(t, "mass", Dimension::mass), required_vector(t, "stiffness", Dimension::stiffness, true)});
}

}  // namespace

Spacecraft read_spacecraft(const TomlTable& table) {
  table.allow_only(spacecraft_keys);
  const double spin = required(table, "spin", Dimension::frequency);
  const auto body = table.table("body");
  if (!body) table.fail("table [body] is missing: the rigid central body, with mass and inertia, was expected");
  std::vector<Cable> cables;
  for (const TomlTable& t : table.tables("cable")) cables.push_back(read_cable(t));
  std::vector<Beam> beams;
  for (const TomlTable& t : table.tables("beam")) beams.push_back(read_beam(t));
  std::vector<SpringMass> masses;
  for (const TomlTable& t : table.tables("spring_mass")) masses.push_back(read_spring_mass(t));
  if (!(spin > 0)) {
    table.break_law("spin", fmt::format("'spin' must be above 0: it is {:.6g} rad/s{}", spin,
                                        spin < 0 ? " (for the other sense of rotation turn axis 3 around)" : cables.empty() ? "" : ", and without it no cable is taut"));
  }
  return Spacecraft(spin, read_body(*body), std::move(cables), std::move(beams), std::move(masses));
}

}  // namespace gyromode::io
