#include "gyromode/base/frequency_unit.h"

#include "gyromode/base/quantity.h"

#include <numbers>

namespace gyromode {

std::string_view to_string(FrequencyUnit unit) {
  switch (unit) {
    case FrequencyUnit::hertz: return "Hz";
    case FrequencyUnit::rpm: return "rpm";
    default: return "rad/s";
  }
}

std::optional<FrequencyUnit> frequency_unit_named(std::string_view word) {
  for (const FrequencyUnit u : {FrequencyUnit::radians, FrequencyUnit::hertz, FrequencyUnit::rpm}) {
    if (to_string(u) == word) return u;
  }
  return std::nullopt;
}

double in_unit(double omega, FrequencyUnit unit) {
  switch (unit) {
    case FrequencyUnit::hertz: return omega / (2 * std::numbers::pi);
    case FrequencyUnit::rpm: return omega * (30 / std::numbers::pi);
    default: return omega;
  }
}

std::optional<FrequencyUnit> frequency_unit_of(std::string_view text) {
  if (!parse_frequency(text)) return std::nullopt;
  const auto ends = [&](std::string_view end) { return text.ends_with(end); };
  if (ends("rpm") || ends("RPM") || ends("/min")) return FrequencyUnit::rpm;
  if (ends("Hz") || ends("rev/s") || ends("rps")) return FrequencyUnit::hertz;
  return std::nullopt;
}

}  // namespace gyromode
