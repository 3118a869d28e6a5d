#pragma once

#include "gyromode/modes/modes.h"
#include "gyromode/system/condensation.h"

namespace gyromode {

/// find_modes() of the condensed system of a whole with massless coordinates: modes and shapes are those of
/// `whole.reduced`; repairs, and their effects, those of the whole matrices. @throws as find_modes()
ModesResult find_modes(const Condensation& whole, const ModesOptions& options = {});

}  // namespace gyromode
