#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gyromode::io {

/// A frequency as people write it: a number in rad/s, or with a unit: "10 rpm", "5Hz", "2 rad/s", "90 deg/s", "1 rev/s", "3 krpm", "1.2 kHz".
/// Nothing where the text is none; finite always.
std::optional<double> parse_frequency(std::string_view text);

/// What parse_frequency accepts, for messages.
inline constexpr std::string_view frequency_form = "a number in rad/s, or one with a unit: rad/s, 1/s, Hz, kHz, rpm, krpm, rev/s, deg/s";

}  // namespace gyromode::io
