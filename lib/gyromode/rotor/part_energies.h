#pragma once

#include "gyromode/rotor/rotor.h"

#include <string>
#include <vector>

namespace gyromode {

/// The quadratic forms of one part of a rotor.
struct PartEnergy {
  std::string part;    ///< "shaft 1", "disk 2", "point mass 1", "bearing 1" with its housing
  double kinetic = 0;  ///< XᴴM_pX
  double strain = 0;   ///< XᴴK_pX, of a shaft with the part of its axial force
};

/// Of a shape X on the coordinates of a rotor.
std::vector<PartEnergy> part_energies(const Rotor& rotor, const ComplexVector& shape);

}  // namespace gyromode
