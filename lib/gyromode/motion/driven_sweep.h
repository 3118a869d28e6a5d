#pragma once

#include "gyromode/motion/frequency_response.h"

#include <functional>
#include <string_view>
#include <vector>

namespace gyromode {

/// A steady response over a grid of whatever it depends on, a frequency or a speed, and the poles in its range.
struct DrivenSweep {
  std::function<ComplexVector(double at)> solved;  ///< H⁻¹f where H is regular
  std::function<ComplexVector(double at)> limit;   ///< from both sides of a pole that is not driven
  std::vector<DrivenMode> poles;                   ///< ascending
  std::string_view progress_of;                    ///< what progress is told

  /// Points of the grid (ascending), and with `resolve` those at 1 ± 10⁻² … 1 ± 10⁻⁵ beside every driven pole. Throws
  /// Interrupted where work was stopped before the first.
  FrequencyResponse over(const Vector& grid, bool resolve, const Progress& progress) const;

 private:
  FrequencyPoint point(double at) const;
  struct Wanted {
    double at;
    const DrivenMode* beside;  // the resonance that it is put beside; null on the grid
  };
  std::vector<Wanted> wanted(const Vector& grid, bool resolve) const;
};

/// Throws InvalidArgument unless the force has n finite numbers and the grid finite frequencies ≥ 0 that ascend.
void require_sweep(const Vector& force, const Vector& grid, Index n);
/// Without those beyond the ends of the grid.
std::vector<DrivenMode> within(const Vector& grid, std::vector<DrivenMode> poles);

}  // namespace gyromode
