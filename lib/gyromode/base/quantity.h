#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gyromode {

/// A frequency as people write it: a number in rad/s, or with a unit: "10 rpm", "5Hz", "2 rad/s", "90 deg/s", "1
/// rev/s", "3 krpm", "1.2 kHz". Nothing where the text is none; finite always.
std::optional<double> parse_frequency(std::string_view text);

/// What parse_frequency accepts, for messages.
inline constexpr std::string_view frequency_form =
    "a number in rad/s, or one with a unit: rad/s, 1/s, Hz, mHz, kHz, MHz, rpm, krpm, rev/s, deg/s";

/// What a number of a model file measures, in SI: rad/s, m, rad, kg, kg/m, kg m², N/m, N m², s, N,
/// N m, N m/rad, Pa, kg/m³, kg m, 1.
enum class Dimension {
  frequency,
  length,
  angle,
  mass,
  line_density,
  inertia,
  stiffness,
  bending_stiffness,
  time,
  force,
  moment,
  tilt_stiffness,
  modulus,
  density,
  unbalance,
  ratio
};

/// "25 mm", "1.65 g/m", "90 deg": a number in SI, or with a unit of that dimension. Nothing where the text is none;
/// finite always.
std::optional<double> parse_quantity(std::string_view text, Dimension dimension);
/// The SI unit: "rad/s", "kg m²".
std::string_view unit_of(Dimension dimension);
/// What it accepts, for messages.
std::string_view form_of(Dimension dimension);

}  // namespace gyromode
