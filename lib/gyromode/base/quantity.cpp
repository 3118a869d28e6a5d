#include "gyromode/base/quantity.h"

#include "gyromode/base/number.h"

#include <cmath>
#include <numbers>
#include <span>

namespace gyromode {

namespace {

struct Unit {
  std::string_view name;
  double si;
};

constexpr double pi = std::numbers::pi;
constexpr Unit frequency_units[] = {{"", 1},
                                    {"rad/s", 1},
                                    {"Hz", 2 * pi},
                                    {"kHz", 2000 * pi},
                                    {"rpm", pi / 30},
                                    {"krpm", 1000 * pi / 30},
                                    {"rev/s", 2 * pi},
                                    {"1/s", 1},
                                    {"deg/s", pi / 180},
                                    {"mHz", 2e-3 * pi},
                                    {"MHz", 2e6 * pi},
                                    {"RPM", pi / 30},
                                    {"rev/min", pi / 30},
                                    {"1/min", pi / 30},
                                    {"r/min", pi / 30},
                                    {"rps", 2 * pi},
                                    {"°/s", pi / 180},
                                    {"mrad/s", 1e-3}};
constexpr Unit time_units[] = {{"", 1}, {"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"µs", 1e-6}, {"min", 60}, {"h", 3600}};
constexpr Unit force_units[] = {{"", 1}, {"N", 1}, {"kN", 1e3}, {"mN", 1e-3}, {"N s", 1}, {"Ns", 1}};
constexpr Unit moment_units[] = {{"", 1}, {"N m", 1}, {"Nm", 1}, {"kN m", 1e3}, {"kNm", 1e3}, {"N m s", 1}, {"Nms", 1}};
constexpr Unit length_units[] = {{"", 1}, {"m", 1}, {"mm", 1e-3}, {"cm", 1e-2}, {"km", 1e3}};
constexpr Unit angle_units[] = {{"", 1}, {"rad", 1}, {"deg", pi / 180}, {"°", pi / 180}};
constexpr Unit mass_units[] = {{"", 1}, {"kg", 1}, {"g", 1e-3}, {"t", 1e3}};
constexpr Unit line_density_units[] = {{"", 1}, {"kg/m", 1}, {"g/m", 1e-3}, {"kg/km", 1e-3}};
constexpr Unit inertia_units[] = {{"", 1}, {"kg m²", 1}, {"kg m2", 1}, {"kg m^2", 1}};
constexpr Unit stiffness_units[] = {{"", 1}, {"N/m", 1}, {"N/mm", 1e3}, {"kN/m", 1e3}};
constexpr Unit bending_units[] = {{"", 1}, {"N m²", 1}, {"N m2", 1}, {"N m^2", 1}};

constexpr Unit tilt_units[] = {{"", 1}, {"N m/rad", 1}, {"Nm/rad", 1}, {"kN m/rad", 1e3}};
constexpr Unit modulus_units[] = {{"", 1}, {"Pa", 1}, {"MPa", 1e6}, {"GPa", 1e9}, {"N/m²", 1}, {"N/m2", 1}, {"N/mm²", 1e6}, {"N/mm2", 1e6}};
constexpr Unit density_units[] = {{"", 1}, {"kg/m³", 1}, {"kg/m3", 1}, {"kg/m^3", 1}, {"g/cm³", 1e3}, {"g/cm3", 1e3}};
constexpr Unit unbalance_units[] = {{"", 1},         {"kg m", 1},     {"kg mm", 1e-3}, {"g m", 1e-3},  {"g cm", 1e-5}, {"g mm", 1e-6},
                                    {"kg·m", 1},     {"kg·mm", 1e-3}, {"g·m", 1e-3},   {"g·cm", 1e-5}, {"g·mm", 1e-6}, {"kg.m", 1},
                                    {"kg.mm", 1e-3}, {"g.m", 1e-3},   {"g.cm", 1e-5},  {"g.mm", 1e-6}};
constexpr Unit ratio_units[] = {{"", 1}, {"1", 1}, {"%", 1e-2}};

std::span<const Unit> units_of(Dimension d) {
  switch (d) {
    case Dimension::length: return length_units;
    case Dimension::angle: return angle_units;
    case Dimension::mass: return mass_units;
    case Dimension::line_density: return line_density_units;
    case Dimension::inertia: return inertia_units;
    case Dimension::stiffness: return stiffness_units;
    case Dimension::bending_stiffness: return bending_units;
    case Dimension::time: return time_units;
    case Dimension::force: return force_units;
    case Dimension::moment: return moment_units;
    case Dimension::tilt_stiffness: return tilt_units;
    case Dimension::modulus: return modulus_units;
    case Dimension::density: return density_units;
    case Dimension::unbalance: return unbalance_units;
    case Dimension::ratio: return ratio_units;
    default: return frequency_units;
  }
}

std::string_view trimmed(std::string_view s) {
  constexpr std::string_view blanks = " \t";
  s.remove_prefix(std::min(s.find_first_not_of(blanks), s.size()));
  return s.substr(0, s.find_last_not_of(blanks) + 1);
}

// The length of the leading number, where 'e' belongs to it only before a digit or a sign ("5e3 Hz", but "3 eV" would
// be a unit).
std::size_t number_length(std::string_view s) {
  std::size_t k = 0;
  while (k < s.size()) {
    const char c = s[k];
    const bool exponent =
        (c == 'e' || c == 'E') && k > 0 && k + 1 < s.size() && (std::string_view("+-0123456789").find(s[k + 1]) != std::string_view::npos);
    const bool sign = (c == '+' || c == '-') && (k == 0 || s[k - 1] == 'e' || s[k - 1] == 'E');
    if (!exponent && !sign && c != '.' && !(c >= '0' && c <= '9')) break;
    ++k;
  }
  return k;
}

}  // namespace

// The first with a name.
std::string_view unit_of(Dimension dimension) { return units_of(dimension)[1].name; }

std::optional<double> parse_quantity(std::string_view text, Dimension dimension) {
  const std::string_view s = trimmed(text);
  const std::size_t length = number_length(s);
  const Parsed number = parse_real(s.substr(0, length));
  if (number.outcome != Parsed::ok) return std::nullopt;
  const std::string_view name = trimmed(s.substr(length));
  for (const Unit& unit : units_of(dimension)) {
    if (unit.name == name) {
      const double value = number.value * unit.si;
      return std::isfinite(value) ? std::optional(value) : std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<double> parse_frequency(std::string_view text) { return parse_quantity(text, Dimension::frequency); }

std::string_view form_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::length: return "a number in m, or one with a unit: m, mm, cm, km";
    case Dimension::angle: return "a number in rad, or one with a unit: rad, deg, °";
    case Dimension::mass: return "a number in kg, or one with a unit: kg, g, t";
    case Dimension::line_density: return "a number in kg/m, or one with a unit: kg/m, g/m, kg/km";
    case Dimension::inertia: return "a number in kg m², or one with the unit: kg m², kg m2, kg m^2";
    case Dimension::stiffness: return "a number in N/m, or one with a unit: N/m, N/mm, kN/m";
    case Dimension::bending_stiffness: return "a number in N m², or one with the unit: N m², N m2, N m^2";
    case Dimension::time: return "a number in s, or one with a unit: s, ms, us, min, h";
    case Dimension::force: return "a number in N, or one with a unit: N, kN, mN";
    case Dimension::moment: return "a number in N m, or one with a unit: N m, kN m";
    case Dimension::tilt_stiffness: return "a number in N m/rad, or one with a unit: N m/rad, kN m/rad";
    case Dimension::modulus: return "a number in Pa, or one with a unit: Pa, MPa, GPa, N/mm²";
    case Dimension::density: return "a number in kg/m³, or one with a unit: kg/m³, g/cm³";
    case Dimension::unbalance: return "a number in kg m, or one with a unit: kg m, g m, g cm, g mm";
    case Dimension::ratio: return "a number";
    default: return frequency_form;
  }
}

}  // namespace gyromode
