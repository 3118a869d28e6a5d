#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace gyromode {

/// A word read as a real number.
struct Parsed {
  enum Outcome { ok, not_a_number, not_finite } outcome = ok;
  double value = 0;
};

/// The whole word as a decimal number, by std::from_chars (no locale), with an optional '+' and Fortran's exponent
/// letter D. Too small for a double is 0; NaN, infinity and too large are `not_finite`.
Parsed parse_real(std::string_view word);

/// The whole word as an integer that fits 64 bits, with an optional '+'.
std::optional<std::int64_t> whole_number(std::string_view word);

}  // namespace gyromode
