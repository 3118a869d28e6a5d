#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gyromode {

/// In which unit frequencies and spins are shown to people; inside, and in JSON, they are in rad/s.
enum class FrequencyUnit { radians, hertz, rpm };

/// "rad/s", "Hz", "rpm", and back.
std::string_view to_string(FrequencyUnit unit);
std::optional<FrequencyUnit> frequency_unit_named(std::string_view word);

/// ω, rad/s, in that unit.
double in_unit(double omega, FrequencyUnit unit);

/// Of a frequency as people write it ("300rpm", "1.5 kHz") the unit to answer in; nothing of a bare number, one in
/// rad/s or 1/s, or no frequency at all.
std::optional<FrequencyUnit> frequency_unit_of(std::string_view text);

}  // namespace gyromode
