#pragma once

#include "gyromode/sweep/meetings.h"
#include "gyromode/sweep/spin_track.h"

namespace gyromode {

/// Of a family whose G goes with the spin alone by the pencil (T13), counted; else by the signs of ω − mΩ at the points
/// of the track, refined.
Intersections intersections(SpinTrack& track, const SpinSource& source, double order);

}  // namespace gyromode
