#pragma once

#include "gyromode/modes/spacecraft_solution.h"

namespace gyromode {

/// Back in rad/s; an end that was not moved is exactly the one asked for.
Window in_units(const Window& w, double unit, const Window& requested);

/// Fields of wires are marched in some ω/Ω steps, and followed no farther than this.
constexpr double farthest_over_spin = 1e7;

/// [a, b) over the spin, with b in the gap after the `lowest`-th mode from a on that is no rigid-body one. Throws std::invalid_argument where wires have
/// fewer modes within reach.
Window lowest_window(const SpacecraftSolution& s, Index lowest, const Window& requested);

/// Of the roots found inside, all over the spin.
Coverage coverage_of(const SpacecraftSolution& s, const Window& requested, const Window& window, const std::vector<Root>& inside);

}  // namespace gyromode
