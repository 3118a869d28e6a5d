#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/dense/spectrum.h"
#include "gyromode/spectrum/result.h"

namespace gyromode {

/// What to compute, and at what price.
struct ModesOptions {
  dense::Method method = dense::Method::automatic;  ///< the best for the class; the classical 2n methods are there to compare with
  Window window;                                    ///< modes reported; a dense solver finds all whatever the window
  std::optional<Index> lowest;                      ///< only so many that are not rigid-body modes, with the rigid-body ones below them
  bool shapes = false;                              ///< n complex numbers a mode
  Progress progress;                                ///< told modes or components; where it stops, what is known by then is returned (Coverage::interrupted), or Interrupted thrown where nothing is
};

/// All modes of a dense system in a window, with stability verdict and coverage (theory §1, §3–§5).
/// Throws InvalidArgument for a window that is none, NotApplicable, NotConverged, TooLarge.
ModesResult find_modes(const System& system, const ModesOptions& options = {});
ModesResult find_modes(const FirstOrderSystem& system, const ModesOptions& options = {});

}  // namespace gyromode
