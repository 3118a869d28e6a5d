#pragma once

#include "gyromode/system/system.h"

#include <vector>

namespace gyromode {

/// q of q e^{jωt} under a force f e^{jωt}: H(ω) q = f.
struct FrequencyPoint {
  double omega = 0;
  ComplexVector q;          ///< n; empty at a resonance
  bool resonance = false;   ///< ω is a mode's to rounding, and the force drives it: the response is unbounded
  bool added = false;       ///< not on the grid: put beside a resonance to show it
};

struct FrequencyResponse {
  std::vector<FrequencyPoint> points;  ///< ascending in ω
  std::vector<double> resonances;      ///< modes in the range of the grid that the force drives
};

/// H(ω)⁻¹f on a grid (ascending, ω ≥ 0, rad per unit of time), by one factorisation a point. With `resolve` points at ω_s(1 ± 10⁻²) … ω_s(1 ± 10⁻⁵) are put beside every mode ω_s in range that the
/// force drives. Where a grid point is on a mode that it does not drive, the value is the limit from both sides.
/// Throws std::invalid_argument where sizes do not fit, the grid does not ascend, or a number is not finite.
FrequencyResponse frequency_response(const System& system, const Vector& force, const Vector& grid, bool resolve = true);

}  // namespace gyromode
