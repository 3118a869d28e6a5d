#pragma once

#include "gyromode/elements/discretise.h"
#include "gyromode/modes/modes.h"

namespace gyromode {

/// The modes of a spacecraft in finite elements, `twin` = discretise(spacecraft, mesh), the tilt among them named.
ModesResult find_modes_of_twin(const Spacecraft& spacecraft, const Mesh& mesh, const System& twin, const ModesOptions& options);
/// The same, the twin made here.
inline ModesResult find_modes(const Spacecraft& spacecraft, const Mesh& mesh, const ModesOptions& options) {
  return find_modes_of_twin(spacecraft, mesh, discretise(spacecraft, mesh), options);
}

}  // namespace gyromode
