#include "gyromode/modes/modes.h"

#include "gyromode/base/error.h"
#include "gyromode/modes/answer.h"
#include "gyromode/modes/condensed.h"
#include "gyromode/modes/keep.h"
#include "gyromode/modes/matrix_spectrum.h"
#include "gyromode/modes/repair_effects.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode {

namespace {

void require_method(Method method) {
  if (method == Method::exact) {
    throw NotApplicable(
        "method 'exact' serves spacecraft models with continuum booms, and this is a matrix model; 'auto', 'quadrature', 'hidden', "
        "'general', 'first-order' or 'symmetric-2n' apply");
  }
}

std::vector<Index> positions_of(const Labels& chosen, const Labels& all) {
  std::vector<Index> positions;
  for (const std::string& label : chosen) {
    const auto at = std::find(all.begin(), all.end(), label);
    if (at == all.end()) throw InvalidArgument(fmt::format("keep: '{}' is no coordinate of the model", label));
    positions.push_back(at - all.begin());
  }
  return positions;
}

// `of_whole`: the condensation that the system is from, for state_effects().
template <class AnySystem, class... OfWhole>
ModesResult answered(const AnySystem& system, const std::vector<Repair>& repairs, const ModesOptions& options, OfWhole... of_whole) {
  const MatrixSpectrum spectrum(solve_components(system, options.method, options.progress));
  ModesResult r = modes_of(spectrum, options);
  r.repairs = repairs;
  if (!r.repairs.empty() && !r.coverage.interrupted) {
    options.progress.stage("effect of what was repaired");
    state_effects(system, spectrum, r, of_whole...);
  }
  r.withhold_doubtful_verdict();
  return r;
}

}  // namespace

ModesResult find_modes(const System& system, const ModesOptions& options) {
  require_options(options);
  require_method(options.method);
  if (!options.keep.empty()) return find_modes_keeping(system, positions_of(options.keep, system.labels()), options);
  return answered(system, system.repairs(), options);
}

ModesResult find_modes(const Condensation& whole, const ModesOptions& options) {
  require_options(options);
  require_method(options.method);
  const System& system = whole.reduced;
  if (options.keep.empty()) return answered(system, whole.repairs, options, &whole);
  ModesResult r = find_modes_keeping(system, positions_of(options.keep, system.labels()), options);
  r.repairs = whole.repairs;
  r.withhold_doubtful_verdict();
  return r;
}

ModesResult find_modes(const FirstOrderSystem& system, const ModesOptions& options) {
  require_options(options);
  require_method(options.method);
  if (!options.keep.empty()) throw NotApplicable("--keep condenses M, G, K of second order; this model is of first order");
  return answered(system, system.repairs(), options);
}

}  // namespace gyromode
