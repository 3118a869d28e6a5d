// Modes of sparse systems.
#include "gyromode/base/error.h"
#include "gyromode/modes/answer.h"
#include "gyromode/modes/isotropic_spectrum.h"
#include "gyromode/modes/modes.h"
#include "gyromode/modes/sparse_spectrum.h"
#include "gyromode/sparse/blas_threads.h"
#include "gyromode/sparse/matrix.h"

namespace gyromode {

namespace {

// Where motions of negative energy are too many to be looked for one by one the dense engine has all of them.
bool serves_dense(const SparseSystem& s) {
  constexpr Index most = 2000;
  return s.size() <= most && !s.basis() && !s.singular_mass();
}

System dense_of(const SparseSystem& s) {
  return System(sparse::full(s.mass(), 1), sparse::full(s.gyroscopic(), -1), sparse::full(s.stiffness(), 1));
}

}  // namespace

ModesResult find_modes(const SparseSystem& system, const ModesOptions& options) {
  require_options(options);
  if (!options.keep.empty()) throw NotApplicable("--keep serves dense matrices");
  if (options.method != Method::automatic)
    throw NotApplicable("a sparse model has one method, 'auto': the others serve dense matrices and spacecraft");
  const auto threads = sparse::few_blas_threads(system.size());
  if (const std::optional<sparse::Isotropy> isotropy = sparse::isotropy_of(system)) {
    const IsotropicSpectrum spectrum(system, *isotropy, options.progress);
    if (spectrum.serves()) return modes_of(spectrum, options);
  }
  const SparseSpectrum spectrum(system, options.progress);
  if (!spectrum.balance().closed && serves_dense(system)) return find_modes(dense_of(system), options);
  return modes_of(spectrum, options);
}

CountResult count_modes(const SparseSystem& system, const Window& window) {
  require_window(window);
  const auto threads = sparse::few_blas_threads(system.size());
  if (const std::optional<sparse::Isotropy> isotropy = sparse::isotropy_of(system)) {
    const IsotropicSpectrum spectrum(system, *isotropy, {});
    if (spectrum.serves()) return count_of(spectrum, window);
  }
  const SparseSpectrum spectrum(system);
  if (!spectrum.balance().closed && serves_dense(system)) return count_modes(dense_of(system), window);
  return count_of(spectrum, window);
}

}  // namespace gyromode
