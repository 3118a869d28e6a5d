#include "gyromode/modes/modes.h"

#include "gyromode/modes/answer.h"
#include "gyromode/modes/matrix_spectrum.h"

namespace gyromode {

ModesResult find_modes(const System& system, const ModesOptions& options) {
  require_options(options);
  return modes_of(MatrixSpectrum(solve_components(system, options.method, options.progress)), options);
}

ModesResult find_modes(const FirstOrderSystem& system, const ModesOptions& options) {
  require_options(options);
  return modes_of(MatrixSpectrum(solve_components(system, options.method, options.progress)), options);
}

}  // namespace gyromode
