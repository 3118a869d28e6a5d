#pragma once

#include "gyromode/appendage/parts.h"
#include "gyromode/elements/discretise.h"

namespace gyromode {

/// Throws InvalidArgument where the spacecraft has no such part, or `along` is outside [0, 1].
void require_point(const Spacecraft& s, const BoomPoint& point);
/// Its steady place from the centre of mass P of the complete satellite, m.
Eigen::Vector3d steady_place(const Spacecraft& s, const BoomPoint& point);
/// Its displacement relative to the body as a linear map of the twin's coordinates, 3 × n.
Matrix relative_displacement(const Spacecraft& s, const Mesh& mesh, const System& twin, const BoomPoint& point);

}  // namespace gyromode
