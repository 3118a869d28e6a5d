#pragma once

#include "gyromode/roots/certified_roots.h"
#include "gyromode/spacecraft/spacecraft.h"

namespace gyromode {

/// What a twin of finite elements knows of negative energy and growth: first a small one of some milliseconds (attempt
/// 0), then one of some 400 coordinates at most (attempt 1), for this is a dense eigenproblem. Nothing after that. Over
/// the spin.
std::optional<Seeds> seeds_of(const Spacecraft& s, Index attempt);

}  // namespace gyromode
