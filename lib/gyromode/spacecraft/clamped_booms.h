#pragma once

#include "gyromode/spacecraft/boom_facts.h"
#include "gyromode/spacecraft/spacecraft.h"

namespace gyromode {

/// Of every boom and sprung mass, the lowest `count` or as many as there are.
std::vector<ClampedBoom> clamped_booms(const Spacecraft& s, Index count);

}  // namespace gyromode
