#include "gyromode/appendage/mass_properties.h"

namespace gyromode {

MassProperties MassProperties::seen_from(double height) const {
  const Eigen::Vector3d shift(0, 0, -height);
  MassProperties moved = *this;
  moved.first += mass * shift;
  moved.second += first * shift.transpose() + shift * first.transpose() + mass * shift * shift.transpose();
  return moved;
}

}  // namespace gyromode
