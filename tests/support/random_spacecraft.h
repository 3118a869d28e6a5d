#pragma once

#include "gyromode/spacecraft/spacecraft.h"

#include <cstdint>

namespace gyromode {

/// A balanced satellite of the seed: 2–8 wires in rings of equal ones or of all sorts (tip masses 0–10 × wire mass,
/// radius 0–1 × length, heights), 0–2 beams, 0–3 sprung masses, a body that spins about its axis of largest, smallest
/// or middle inertia. Sizes over some decades.
Spacecraft random_spacecraft(std::uint64_t seed);

}  // namespace gyromode
