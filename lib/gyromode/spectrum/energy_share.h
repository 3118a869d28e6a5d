#pragma once

#include <cmath>
#include <string>

namespace gyromode {

/// How much of the energies of a motion is in one part of a model; those of all parts sum to 1.
struct EnergyShare {
  std::string part;              ///< "disk 2", "cable 1", or a coordinate
  double kinetic = 0;            ///< of XᴴMX, in the axes of the model
  double strain = std::nan("");  ///< of XᴴKX; not a number where the model does not say, or K holds nothing of it
};

}  // namespace gyromode
