#pragma once

#include "gyromode/modes/components.h"
#include "gyromode/motion/frequency_response.h"
#include "gyromode/motion/unit_masses.h"

#include <vector>

namespace gyromode {

/// Every mode of a system, ascending in ω; zero roots as one mode at 0, if there are any. `solved` is units.system
/// solved, `force` in its coordinates.
std::vector<DrivenMode> driven_modes(const SolvedSystem& solved, const UnitMasses& units, const Vector& force);

}  // namespace gyromode
