#pragma once

#include "gyromode/spacecraft/spacecraft.h"

namespace gyromode {

/// The lowest frequencies of a boom on a body that only spins: the poles of the condensed impedance. In turning axes.
struct ClampedBoom {
  std::string name;                  ///< "cables 1, 2, in plane"; equal ones together
  std::vector<double> frequencies;   ///< rad/s, ascending
};

/// Of every boom and sprung mass, the lowest `count` or as many as there are.
std::vector<ClampedBoom> clamped_booms(const Spacecraft& s, Index count);

}  // namespace gyromode
