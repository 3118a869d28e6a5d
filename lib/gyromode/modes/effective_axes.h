#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode {

class SpacecraftSpectrum;

/// Of a mode, the angle from axis 1 to the axis of the body about which, at its frequency, rotations are in phase and rotations across it in quadrature: principal axes of the effective inertia of hub
/// and booms (Boland & Janssens 1979, Fig. 4, Eq. 19).
struct EffectiveAxes {
  double omega = 0;  ///< rad/s
  double angle = 0;  ///< ψ, rad: in [−π/4, π/4] for the first, then of the multiples of π/2 apart the one nearest to the mode before
};
/// Of the lowest `count` modes; empty where ψ = 0 throughout, as axes 1 and 2 are such axes.
std::vector<EffectiveAxes> effective_axes(const SpacecraftSpectrum& solved, Index count);

}  // namespace gyromode
