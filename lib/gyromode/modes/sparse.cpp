// Modes of sparse systems.
#include "gyromode/base/error.h"
#include "gyromode/lapack/team.h"
#include "gyromode/modes/answer.h"
#include "gyromode/modes/modes.h"
#include "gyromode/modes/sparse_spectrum.h"

namespace gyromode {

namespace {

// Threads of the BLAS gain nothing in the small fronts of a mesh (theory sparse §1).
std::unique_ptr<lapack::BlasOnOneThread> few_threads(Index n) {
  constexpr Index large_fronts = 300000;
  return n < large_fronts ? std::make_unique<lapack::BlasOnOneThread>() : nullptr;
}

}  // namespace

ModesResult find_modes(const SparseSystem& system, const ModesOptions& options) {
  require_options(options);
  if (!options.keep.empty()) throw NotApplicable("--keep serves dense matrices");
  if (options.method != Method::automatic)
    throw NotApplicable("a sparse model has one method, 'auto': the others serve dense matrices and spacecraft");
  const auto threads = few_threads(system.size());
  return modes_of(SparseSpectrum(system, options.progress), options);
}

CountResult count_modes(const SparseSystem& system, const Window& window) {
  require_window(window);
  const auto threads = few_threads(system.size());
  return count_of(SparseSpectrum(system), window);
}

}  // namespace gyromode
