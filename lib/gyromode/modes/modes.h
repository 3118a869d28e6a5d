#pragma once

#include "gyromode/base/labels.h"
#include "gyromode/base/progress.h"
#include "gyromode/spectrum/method.h"
#include "gyromode/spectrum/result.h"
#include "gyromode/spacecraft/spacecraft.h"
#include "gyromode/sparse/sparse_system.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

#include <string_view>
#include <vector>

namespace gyromode {

/// What to compute, and at what price.
struct ModesOptions {
  Method method = Method::automatic;  ///< the best for the class; the classical 2n methods are there to compare with
  Window window;                      ///< modes reported; a dense solver finds all whatever the window
  std::optional<Index> lowest;        ///< only so many that are not rigid-body modes, with the rigid-body ones below them
  /// matrices of second order: coordinates to see the modes from (modes in which they take no part are local); empty:
  /// all
  Labels keep;
  bool shapes = false;  ///< n complex numbers a mode
  /// told modes or components; where it stops, what is known by then is returned (Coverage::interrupted), or
  /// Interrupted thrown where nothing is
  Progress progress;
};

/// All modes of a dense system in a window, with stability verdict and coverage (theory §1, §3–§5).
/// @throws InvalidArgument for a window that is none, `lowest` below 1, or a label to keep that is no coordinate
/// @throws NotApplicable where the method does not serve the system
/// @throws NotConverged where LAPACK does not converge; TooLarge beyond its 32-bit sizes
ModesResult find_modes(const System& system, const ModesOptions& options = {});
ModesResult find_modes(const FirstOrderSystem& system, const ModesOptions& options = {});

/// Modes of a spacecraft with exact booms in a window, or the lowest so many: none missing where `complete`. Spin phase
/// and axial translation (ω = 0) and the tilt of the momentum axis (ω = Ω) are listed as rigid-body modes; translation
/// across the axis is no mode of a body free in space and is not.
/// @throws InvalidArgument for an open window without `lowest`, as there are infinitely many modes
/// @throws NotApplicable for a method of matrix models; TooLarge for more than 20 000 modes of booms
ModesResult find_modes(const Spacecraft& spacecraft, const ModesOptions& options = {});

/// Modes of a sparse system in a window, or the lowest so many, by ranges; counted by factorisations.
/// @throws InvalidArgument for an open window without `lowest`; NotApplicable for a method, coordinates to keep, or a
/// singular K of which what is free cannot be told from what is soft; TooLarge
ModesResult find_modes(const SparseSystem& system, const ModesOptions& options = {});

/// A factorisation that find_modes() would make, as its analysis estimates it.
struct PlannedFactorisation {
  std::string_view what;              ///< "K", "K, in phase", "H*(ω)", …
  Index order = 0;                    ///< of the matrix that is factored
  double entries = 0;                 ///< of the factor
  double megabytes = 0;               ///< of memory
  double megabytes_beside_files = 0;  ///< of memory where the factor is kept in files
  double megabytes_in_files = 0;      ///< of those files
};
std::vector<PlannedFactorisation> plan_of(const SparseSystem& system);

/// How many modes a window holds (theory (T9), (T10)): of matrices all are found and counted, of a spacecraft by the
/// counts at the ends alone.
/// @throws InvalidArgument for a window that is none, or one of a spacecraft with an open end
CountResult count_modes(const System& system, const Window& window);
CountResult count_modes(const FirstOrderSystem& system, const Window& window);
CountResult count_modes(const Spacecraft& spacecraft, const Window& window);
CountResult count_modes(const SparseSystem& system, const Window& window);

}  // namespace gyromode
