#include "gyromode/modes/discrete.h"

#include "gyromode/base/error.h"
#include "gyromode/elements/spin_phase.h"
#include "gyromode/modes/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// The mode at the spin, which linear elements have exactly.
bool name_tilt(ModesResult& r, double spin) {
  constexpr double rounding = 1e-9;
  const auto tilt = std::min_element(r.modes.begin(), r.modes.end(),
                                     [&](const Mode& x, const Mode& y) { return std::abs(x.omega - spin) < std::abs(y.omega - spin); });
  if (tilt == r.modes.end() || !(std::abs(tilt->omega - spin) <= rounding * spin)) return false;
  tilt->kind = ModeKind::rigid_body;
  return true;
}

}  // namespace

ModesResult find_modes_of_twin(const Spacecraft& spacecraft, const Mesh& mesh, const System& whole, const ModesOptions& options) {
  if (!options.keep.empty())
    throw NotApplicable(
        "--keep condenses matrix models; a spacecraft is seen from its body already (gyromode convert writes its matrices)");
  const WithoutSpinPhase rest(whole, spin_phase_of_twin);
  ModesResult r = find_modes(rest.system(), options);
  if (options.lowest && name_tilt(r, spacecraft.spin())) {  // it is not one of those asked for
    ModesOptions one_more = options;
    one_more.lowest = *options.lowest + 1;
    r = find_modes(rest.system(), one_more);
  }
  name_tilt(r, spacecraft.spin());
  for (Mode& m : r.modes) {
    if (options.shapes) m.shape = normalised(rest.restored(m.shape, m.omega));
  }
  r.structure = analyse(whole);
  r.index_balance.zero += 2;
  r.stiffness.zero += 2;
  if (r.coverage.window.a == 0) {
    Mode axial;  // no coordinate of the twin moves in it
    axial.kind = ModeKind::rigid_body;
    axial.energy_sign = 0;
    if (options.shapes) axial.shape = ComplexVector::Zero(whole.size());
    Mode spin = axial;
    if (options.shapes) spin.shape = ComplexVector::Unit(whole.size(), spin_phase_of_twin);
    r.modes.insert(r.modes.begin(), {axial, spin});
    r.coverage.found += 2;
    if (r.coverage.counted) *r.coverage.counted += 2;
  }
  r.solver = fmt::format("finite elements ({} a cable, degree {}), spin phase apart: ", mesh.elements, mesh.degree) + r.solver;
  return r;
}

}  // namespace gyromode
