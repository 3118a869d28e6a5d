#include "gyromode/modes/spacecraft.h"

#include "gyromode/base/error.h"
#include "gyromode/modes/answer.h"
#include "gyromode/modes/spacecraft_spectrum.h"

#include <fmt/format.h>

namespace gyromode {

namespace {

// Before anything is solved.
void require_within_reach(const Spacecraft& s, const Window& w) {
  const double highest = w.open() ? w.a : w.b, farthest = farthest_over_spin * s.spin();
  if (s.cables().empty() || !(highest > farthest)) return;
  throw InvalidArgument(fmt::format("{:.6g} rad/s is beyond reach: fields of wires are followed up to {:.0e} times the spin, {:.6g} rad/s",
                                    highest, farthest_over_spin, farthest));
}

}  // namespace

Structure analyse(const Spacecraft& spacecraft) {
  const SpacecraftImpedance impedance(spacecraft);
  return structure_of(BlockedImpedance(impedance));
}

ModesResult find_modes(const Spacecraft& spacecraft, const ModesOptions& options) {
  require_options(options);
  if (!options.keep.empty())
    throw NotApplicable(
        "--keep condenses matrix models; a spacecraft is seen from its body already (gyromode convert writes its matrices)");
  if (options.method != Method::automatic && options.method != Method::exact) {
    throw NotApplicable(
        "the methods 'quadrature', 'hidden', 'general', 'first-order' and 'symmetric-2n' serve matrices; a spacecraft takes 'exact' or "
        "'discrete'");
  }
  require_within_reach(spacecraft, options.window);
  return modes_of(SpacecraftSpectrum(spacecraft), options);
}

CountResult count_modes(const Spacecraft& spacecraft, const Window& requested) {
  require_window(requested);
  require_within_reach(spacecraft, requested);
  return count_of(SpacecraftSpectrum(spacecraft), requested);
}

ComplexMatrix impedance_at(const Spacecraft& spacecraft, double omega) {
  require_within_reach(spacecraft, {0, omega});
  return SpacecraftImpedance(spacecraft).hub(omega);
}

}  // namespace gyromode
