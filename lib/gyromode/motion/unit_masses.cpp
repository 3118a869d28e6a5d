#include "gyromode/motion/unit_masses.h"

#include "gyromode/system/scale.h"

namespace gyromode {

UnitMasses with_unit_masses(const System& system) {
  const Vector d = unit_diagonal_scale(system.mass());
  return {d, system.replaced(scaled(system.mass(), d), scaled(system.gyroscopic(), d), scaled(system.stiffness(), d))};
}

}  // namespace gyromode
