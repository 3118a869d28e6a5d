// Modes of sparse systems.
#include "gyromode/base/error.h"
#include "gyromode/modes/answer.h"
#include "gyromode/modes/modes.h"
#include "gyromode/modes/sparse_spectrum.h"

namespace gyromode {

ModesResult find_modes(const SparseSystem& system, const ModesOptions& options) {
  require_options(options);
  if (!options.keep.empty()) throw NotApplicable("--keep serves dense matrices");
  if (options.method != Method::automatic)
    throw NotApplicable("a sparse model has one method, 'auto': the others serve dense matrices and spacecraft");
  return modes_of(SparseSpectrum(system, options.progress), options);
}

CountResult count_modes(const SparseSystem& system, const Window& window) {
  require_window(window);
  return count_of(SparseSpectrum(system), window);
}

}  // namespace gyromode
