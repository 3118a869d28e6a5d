#pragma once

#include "gyromode/modes/result.h"

#include <functional>
#include <string>
#include <vector>

namespace gyromode {

/// The verdict at one point of parameter space.
struct StabilityPoint {
  bool lawful = true;          ///< false: no such model (a law is broken); `reason` says which
  Stability stability = Stability::unknown;
  IndexBalance balance;
  double growth_rate = 0;      ///< the largest, 1/s
  std::string reason;

  /// The same verdict for the same reasons: the same numbers of divergent, fluttering and negative-energy motions.
  bool alike(const StabilityPoint& other) const;
};

/// What the modes of a system say.
StabilityPoint stability_point(const ModesResult& result);

/// Where a parameter changes the verdict.
struct CriticalValue {
  std::size_t axis = 0;
  double value = 0;
  StabilityPoint from, to;      ///< below and above
  std::vector<double> others;   ///< the other parameters, in their order
};

struct StabilityMap {
  struct Cell {
    std::vector<double> values;
    StabilityPoint point;
  };
  std::vector<std::vector<double>> axes;
  std::vector<Cell> cells;              ///< the first axis runs fastest
  std::vector<CriticalValue> critical;  ///< along the first axis
};

/// The verdict over a grid of one or two parameters, and the values of the first between neighbours with different verdicts, bisected to `resolution` relative to the step or to the last
/// bit. What lies between two neighbours with the same verdict is not looked at. `progress` is told cells done and in all.
StabilityMap map_stability(const std::function<StabilityPoint(const std::vector<double>&)>& verdict, std::vector<std::vector<double>> axes,
                           const std::function<void(Index, Index)>& progress = {});

}  // namespace gyromode
