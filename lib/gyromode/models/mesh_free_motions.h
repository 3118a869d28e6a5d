#pragma once

#include "gyromode/models/structure_mesh.h"

namespace gyromode {

/// Translations T across the axis, n × 2, where nothing holds them: KT = −Ω²MT to rounding of the file; else n × 0. Of
/// directions across the axis the first is along a coordinate, if one is.
Matrix free_translations(const StructureParts& parts);

/// Translation along the axis and, where positions are known, turning about it through the centre of mass: those that K
/// takes to zero, to rounding of the file. n × 0 … 2
Matrix free_along_axis(const StructureParts& parts);

}  // namespace gyromode
