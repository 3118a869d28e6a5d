#pragma once

#include "gyromode/base/types.h"
#include "gyromode/spacecraft/boom_facts.h"

#include <vector>

namespace gyromode {

class SpacecraftSpectrum;

/// Of the lowest `count` modes; empty where ψ = 0 throughout, as axes 1 and 2 are such axes.
std::vector<EffectiveAxes> effective_axes(const SpacecraftSpectrum& solved, Index count);

}  // namespace gyromode
