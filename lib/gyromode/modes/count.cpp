#include "gyromode/modes/modes.h"

#include "gyromode/modes/answer.h"
#include "gyromode/modes/matrix_spectrum.h"

namespace gyromode {

CountResult count_modes(const System& system, const Window& window) {
  require_window(window);
  return count_of(MatrixSpectrum(solve_components(system, Method::automatic)), window);
}

CountResult count_modes(const FirstOrderSystem& system, const Window& window) {
  require_window(window);
  return count_of(MatrixSpectrum(solve_components(system, Method::automatic)), window);
}

}  // namespace gyromode
