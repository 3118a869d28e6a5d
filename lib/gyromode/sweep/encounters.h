#pragma once

#include "gyromode/sweep/meetings.h"
#include "gyromode/sweep/spin_track.h"

#include <vector>

namespace gyromode {

/// All encounters of the branches of a track, ascending in the spin. Branches of different blocks of the family cross;
/// those of one block and one energy sign do not: they veer where their distance has a minimum so sharp that its width
/// (gap over the difference of the slopes on both sides) lies within the range; those of opposite sign collide. The
/// track is sampled at further spins to find them.
std::vector<Encounter> encounters(SpinTrack& track);

}  // namespace gyromode
