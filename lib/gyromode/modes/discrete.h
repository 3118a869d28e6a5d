#pragma once

#include "gyromode/elements/discretise.h"
#include "gyromode/modes/modes.h"

namespace gyromode {

/// The modes of the twin of finite elements, the tilt among them named.
ModesResult find_modes(const Spacecraft& spacecraft, const Mesh& mesh, const ModesOptions& options);

}  // namespace gyromode
