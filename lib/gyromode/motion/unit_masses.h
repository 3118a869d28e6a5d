#pragma once

#include "gyromode/system/system.h"

namespace gyromode {

/// A system in coordinates q̂, q = d · q̂, in which the diagonal of M lies in [½, 2]. The d are powers of two, so nothing
/// is rounded, and what is measured in these coordinates does not depend on the units of the given ones.
struct UnitMasses {
  Vector scale;   ///< d
  System system;  ///< DMD, DGD, DKD
};
UnitMasses with_unit_masses(const System& system);

}  // namespace gyromode
