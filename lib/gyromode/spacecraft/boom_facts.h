#pragma once

#include <string>
#include <vector>

namespace gyromode {

/// The lowest frequencies of a boom on a body that only spins: the poles of the condensed impedance. In turning axes.
struct ClampedBoom {
  std::string name;                 ///< "cables 1, 2, in plane"; equal ones together
  std::vector<double> frequencies;  ///< rad/s, ascending
};

/// Of a mode, the angle from axis 1 to the axis of the body about which, at its frequency, rotations are in phase and
/// rotations across it in quadrature: principal axes of the effective inertia of hub and booms (Boland & Janssens 1979,
/// Fig. 4, Eq. 19).
struct EffectiveAxes {
  double omega = 0;  ///< rad/s
  double angle = 0;  ///< ψ, rad: in [−π/4, π/4] for the first, then of the multiples of π/2 apart the one nearest to the mode before
};

}  // namespace gyromode
