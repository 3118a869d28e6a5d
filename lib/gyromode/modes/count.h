#pragma once

#include "gyromode/spectrum/result.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

namespace gyromode {

/// The system is solved as well: an indefinite K needs its negative-energy modes, and the solution shows where an endpoint is on a mode. `exact` where the index
/// balance closes and the count agrees with the modes found.
CountResult count_modes(const System& system, const Window& window);
CountResult count_modes(const FirstOrderSystem& system, const Window& window);

}  // namespace gyromode
