#include "gyromode/read/rotor_toml.h"

#include "gyromode/read/part_toml.h"
#include "gyromode/rotor/part_numbers.h"

#include <array>
#include <cmath>

namespace gyromode::io {

namespace {

constexpr std::array<std::string_view, 16> rotor_keys{"kind",    "title",       "reference",  "known",    "parameters", "frame",
                                                      "speed",   "axial_force", "spool",      "material", "shaft",      "disk",
                                                      "bearing", "support",     "point_mass", "labels"};

std::string required_text(const TomlTable& t, std::string_view key, std::string_view what) {
  const auto text = t.text(key);
  if (!text) t.fail(fmt::format("key '{}' is missing: {} was expected", key, what));
  return *text;
}

std::string spool_of(const TomlTable& t) { return t.text("spool").value_or(""); }

Material read_material(const TomlTable& t, const std::string& name) {
  Material m;
  m.name = name;
  t.allow_only(std::array<std::string_view, 4>{"young", "shear", "poisson", "density"});
  m.young = required(t, "young", Dimension::modulus);
  m.density = required(t, "density", Dimension::density);
  const auto shear = t.quantity("shear", Dimension::modulus);
  const auto poisson = t.quantity("poisson", Dimension::ratio);
  if (shear.has_value() == poisson.has_value())
    t.fail(fmt::format("material '{}': one of 'shear' (shear modulus) and 'poisson' (Poisson's ratio) was expected", name));
  if (poisson && !(*poisson > -1 && *poisson <= 0.5))
    t.break_law("poisson", fmt::format("'poisson' must be above -1 and up to 0.5: it is {:.6g}", *poisson));
  m.shear = shear ? *shear : m.young / (2 * (1 + *poisson));
  return checked(t, m);
}

ShaftTheory read_theory(const TomlTable& t) {
  const std::string word = t.text("theory").value_or("timoshenko");
  if (word == "timoshenko") return ShaftTheory::timoshenko;
  if (word == "rayleigh") return ShaftTheory::rayleigh;
  if (word != "euler") t.fail("theory", fmt::format("'{}' is no theory of shafts: timoshenko, rayleigh or euler was expected", word));
  return ShaftTheory::euler;
}

ShaftSection read_shaft(const TomlTable& t) {
  ShaftSection s;
  if (t.has("shear_coefficient")) s.shear_coefficient = 1;  // read below
  s = read_part(t, {"elements", "material", "theory", "spool", "shear_coefficient"}, std::move(s));
  const double elements = t.number("elements").value_or(1);
  if (elements != std::floor(elements) || std::abs(elements) > 1e6)
    t.fail("elements", fmt::format("'elements' = {:.6g}: a whole number was expected", elements));
  s.elements = static_cast<Index>(elements);
  s.material = required_text(t, "material", "the name of a table [material.NAME]");
  s.theory = read_theory(t);
  s.spool = spool_of(t);
  return checked(t, s);
}

// By mass and inertias, or by width, diameters and material.
Disc read_disc(const TomlTable& t) {
  Disc d;
  if (t.has("width") || t.has("outer_diameter") || t.has("material")) d.geometry = DiscGeometry{};
  d = read_part(t, {"spool", "material"}, std::move(d));
  if (d.geometry) d.geometry->material = required_text(t, "material", "the name of a table [material.NAME]");
  d.spool = spool_of(t);
  return checked(t, d);
}

// kyx is kxy, and nothing damps: what is otherwise is not served, and is refused by its name.
void require_conservative(const TomlTable& t, const Bearing& b) {
  if (const auto kyx = t.quantity("kyx", Dimension::stiffness); kyx && *kyx != b.kxy)
    t.break_law(
        "kyx",
        fmt::format(
            "'kyx' = {:.6g} must equal 'kxy' = {:.6g}: an unsymmetric pair is circulatory (of a fluid film or a seal), which is not served",
            *kyx, b.kxy));
  for (const char* key : {"cxx", "cyy", "cxy", "cyx"}) {
    const auto c = t.number(key);
    if (c && *c != 0)
      t.break_law(key, fmt::format("'{}' = {:.6g} is damping, which is not served: leave it out for the undamped modes", key, *c));
  }
}

Bearing read_bearing(const TomlTable& t) {
  Bearing b = read_part<Bearing>(t, {"spool", "to", "kyx", "cxx", "cyy", "cxy", "cyx"});
  b.spool = spool_of(t);
  b.to = t.text("to").value_or("");
  require_conservative(t, b);
  return checked(t, b);
}

Support read_support(const TomlTable& t) {
  Support s = read_part<Support>(t, {"spool", "fixed"});
  s.spool = spool_of(t);
  const std::vector<std::string> fixed = t.words("fixed");
  if (fixed.empty()) t.fail("key 'fixed' is missing: an array of \"x\", \"y\", \"tilt_x\", \"tilt_y\" was expected");
  for (const std::string& word : fixed) {
    bool* held = word == "x" ? &s.x : word == "y" ? &s.y : word == "tilt_x" ? &s.tilt_x : word == "tilt_y" ? &s.tilt_y : nullptr;
    if (!held) t.fail("fixed", fmt::format("'{}' is no direction: \"x\", \"y\", \"tilt_x\" or \"tilt_y\" was expected", word));
    *held = true;
  }
  return s;
}

PointMass read_point_mass(const TomlTable& t) {
  PointMass m = read_part<PointMass>(t, {"spool"});
  m.spool = spool_of(t);
  return checked(t, m);
}

}  // namespace

Rotor read_rotor(const TomlTable& table) {
  table.allow_only(rotor_keys);
  RotorParts parts;
  parts.speed = required(table, "speed", Dimension::frequency);
  parts.axial_force = table.quantity("axial_force", Dimension::force).value_or(0);
  for (const auto& [name, t] : table.named_tables("material")) parts.materials.push_back(read_material(t, name));
  for (const auto& [name, t] : table.named_tables("spool")) {
    Spool s = read_part<Spool>(t);
    s.name = name;
    parts.spools.push_back(checked(t, s));
  }
  for (const TomlTable& t : table.tables("shaft")) parts.shafts.push_back(read_shaft(t));
  for (const TomlTable& t : table.tables("disk")) parts.discs.push_back(read_disc(t));
  for (const TomlTable& t : table.tables("bearing")) parts.bearings.push_back(read_bearing(t));
  for (const TomlTable& t : table.tables("support")) parts.supports.push_back(read_support(t));
  for (const TomlTable& t : table.tables("point_mass")) parts.point_masses.push_back(read_point_mass(t));
  if (parts.shafts.empty()) table.fail("a rotor has no shaft: tables [[shaft]] were expected, in order along the rotor");
  return Rotor(std::move(parts));
}

}  // namespace gyromode::io
