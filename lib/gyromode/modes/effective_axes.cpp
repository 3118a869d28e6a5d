#include "gyromode/modes/effective_axes.h"

#include "gyromode/modes/spacecraft.h"
#include "gyromode/modes/spacecraft_solution.h"

#include <cmath>
#include <numbers>

namespace gyromode {

// ψ = ½ atan2(2c, a − d) of H = [a, c + jb; ·, d] (docs/booms.md (B13)). At Ω both vanish with a common factor, and for an axisymmetric H every angle serves: 0.
std::vector<EffectiveAxes> effective_axes(const Spacecraft& spacecraft, Index count) {
  const SpacecraftImpedance impedance(spacecraft);
  std::vector<EffectiveAxes> all;
  if (structure_of(BlockedImpedance(impedance)).system_class() == SystemClass::quadrature) return all;
  ModesOptions options;
  options.lowest = count;
  for (const Mode& m : find_modes(spacecraft, options).modes) {
    if (m.omega == 0) continue;
    constexpr double beside = 1e-6;
    const bool tilt = m.kind == ModeKind::rigid_body;
    const Eigen::Matrix2cd h = impedance.tilt(m.omega / spacecraft.spin() * (tilt ? 1 + beside : 1));
    const double difference = (h(0, 0) - h(1, 1)).real(), cross = h(0, 1).real();
    double angle = std::hypot(2 * cross, difference) <= 1e-13 * h.norm() ? 0 : 0.5 * std::atan2(2 * cross, difference);
    const double quarter = 0.25 * std::numbers::pi;
    if (angle > quarter) angle -= 2 * quarter;
    if (angle <= -quarter) angle += 2 * quarter;
    all.push_back({m.omega, angle});
  }
  return all;
}

}  // namespace gyromode
