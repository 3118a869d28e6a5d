#include "gyromode/modes/effective_axes.h"

#include "gyromode/modes/answer.h"
#include "gyromode/modes/spacecraft_spectrum.h"
#include "gyromode/structure/realify.h"

namespace gyromode {

// ψ of H = [a, c + jb; ·, d] (docs/booms.md (B13)), followed from mode to mode. At Ω c and a − d vanish with a common
// factor: it is taken beside.
std::vector<EffectiveAxes> effective_axes(const SpacecraftSpectrum& solved, Index count) {
  std::vector<EffectiveAxes> all;
  if (structure_of(solved.certified().blocked()).system_class() == SystemClass::quadrature) return all;
  ModesOptions options;
  options.lowest = count;
  for (const Mode& m : modes_of(solved, options).modes) {
    if (m.omega == 0) continue;
    constexpr double beside = 1e-6;
    const bool tilt = m.kind == ModeKind::rigid_body;
    const Eigen::Matrix2cd h = solved.impedance().tilt(m.omega / solved.unit() * (tilt ? 1 + beside : 1));
    const Realified r = realify_by_angle(h, all.empty() ? 0 : all.back().angle);
    all.push_back({m.omega, *r.angle});
  }
  return all;
}

}  // namespace gyromode
