#include "gyromode/modes/discrete.h"

#include "gyromode/discrete/spin_phase.h"
#include "gyromode/modes/shape.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode {

ModesResult find_modes(const Spacecraft& spacecraft, const Mesh& mesh, const ModesOptions& options) {
  const System whole = discretise(spacecraft, mesh);
  const WithoutSpinPhase rest(whole, spin_phase_of_twin);
  ModesResult r = find_modes(rest.system(), options);
  bool tilt_named = false;
  for (Mode& m : r.modes) {
    if (options.shapes) m.shape = normalised(rest.restored(m.shape, m.omega));
    if (tilt_named || !(std::abs(m.omega - spacecraft.spin()) <= 8 * m.error_bound + 1e-12 * spacecraft.spin())) continue;
    m.kind = ModeKind::rigid_body;
    tilt_named = true;
  }
  r.structure = analyse(whole, options.structure);
  r.index_balance.zero += 1;
  r.stiffness.zero += 1;
  if (r.stiffness.sign == Sign::positive) r.stiffness.sign = Sign::semidefinite;
  if (r.coverage.window.a == 0) {
    Mode spin;
    spin.kind = ModeKind::rigid_body;
    spin.energy_sign = 0;
    if (options.shapes) spin.shape = ComplexVector::Unit(whole.size(), spin_phase_of_twin);
    r.modes.insert(r.modes.begin(), std::move(spin));
    r.coverage.found += 1;
    if (r.coverage.counted) *r.coverage.counted += 1;
  }
  r.path = fmt::format("finite elements ({} a cable, degree {}), spin phase apart: ", mesh.elements, mesh.degree) + r.path;
  return r;
}

}  // namespace gyromode
