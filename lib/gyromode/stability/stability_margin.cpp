#include "gyromode/stability/stability_margin.h"

#include "gyromode/lapack/symmetric.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

std::optional<std::array<double, 2>> nearest_opposite_pair(const std::vector<Mode>& modes) {
  std::optional<std::array<double, 2>> nearest;
  const Mode* before = nullptr;
  for (const Mode& m : modes) {
    if (m.omega == 0) continue;
    const bool opposite = before && (before->energy_sign * m.energy_sign < 0 || (before->energy_sign == 0 && m.energy_sign == 0));
    if (opposite && (!nearest || m.omega - before->omega < (*nearest)[1] - (*nearest)[0])) nearest = {before->omega, m.omega};
    before = &m;
  }
  return nearest;
}

std::optional<double> stiffness_margin(const System& system, Index zero) {
  Vector values = lapack::symmetric_definite_eigen(system.stiffness(), system.mass()).values;
  std::sort(values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  if (zero >= values.size()) return std::nullopt;
  return values(zero);
}

}  // namespace gyromode
