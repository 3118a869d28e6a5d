#pragma once

#include "gyromode/rotor/rotor.h"
#include "gyromode/spectrum/result.h"

#include <vector>

namespace gyromode {

/// Lines for pictures, along z: every shaft through its stations and points between, every disc as a line across the
/// axis of its radius (by mass and inertia √(2I_p/m)), every bearing as one point.
std::vector<ModelOutline> outlines_of(const Rotor& rotor);
/// Where a shape on the coordinates of the rotor takes their points, 3 × points each: between stations by the cubic
/// through displacements and rotations, discs as they tilt.
std::vector<ComplexMatrix> displacements_of(const Rotor& rotor, const std::vector<ModelOutline>& outlines, const ComplexVector& shape);

/// Points of a shaft from one station to the next.
inline constexpr Index points_between_stations = 4;

}  // namespace gyromode
