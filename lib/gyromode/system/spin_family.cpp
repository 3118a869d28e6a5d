#include "gyromode/system/spin_family.h"

#include <utility>

namespace gyromode {

System SpinFamily::at(double spin) const {
  Matrix g = gyroscopic, k = stiffness;
  if (gyroscopic_per_spin.size() > 0) g += spin * gyroscopic_per_spin;
  if (stiffness_per_spin2.size() > 0) k += spin * spin * stiffness_per_spin2;
  return System(mass, std::move(g), std::move(k), labels);
}

}  // namespace gyromode
