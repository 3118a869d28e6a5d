#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/stability/stability_point.h"

#include <functional>
#include <vector>

namespace gyromode {

/// Where a parameter changes the verdict.
struct CriticalValue {
  std::size_t axis = 0;        ///< the parameter that changes: 0, the first
  double value = 0;            ///< the middle of the bracket
  double lo = 0;               ///< `from` was found here
  double hi = 0;               ///< and `to` here, with no verdict of any width between
  StabilityPoint from;         ///< the verdict below, decided
  StabilityPoint to;           ///< the verdict above, decided
  std::vector<double> others;  ///< the other parameters, in their order
};

/// Verdicts over a grid of one or two parameters.
struct StabilityMap {
  /// The verdict at one point of the grid.
  struct Cell {
    std::vector<double> values;  ///< of the parameters, SI
    StabilityPoint point;        ///< the verdict there
  };
  std::vector<std::vector<double>> axes;  ///< values of each parameter, ascending
  std::vector<Cell> cells;                ///< the first axis runs fastest
  std::vector<CriticalValue> critical;    ///< along the first axis
  Index evaluations = 0;                  ///< of the verdict between the cells, to find the critical values
  bool interrupted = false;               ///< stopped before it was done
};

/// The verdict over a grid of one or two parameters, and where along the first it changes between neighbouring cells
/// that have one: bisected to BorderSearch::resolution of the range or to the last bit. Cells and points without a
/// verdict (`unknown`, no model) are no border by themselves; between two different verdicts they widen the bracket of
/// the one border there. What lies between two neighbours with the same verdict is not looked at, but for the
/// `thresholds`. `progress` is told "cells". Where it stops, cells not looked at have no verdict, and critical values
/// are those of the rows that were finished.
///
/// `thresholds`: values of the first parameter, at one value of the second (nothing without it), at which the verdict
/// may change and which are known beforehand: where K is singular. The verdict is asked for between neighbouring ones,
/// too, so that what holds between two of them is in the map, however narrow.
using Thresholds = std::function<std::vector<double>(const std::vector<double>& others)>;
/// `suspected`: values of the first parameter near which flutter may begin or end: the verdict is asked for between
/// neighbouring ones too; called for rows with motions of negative energy, flutter, or thresholds.
StabilityMap map_stability(const std::function<StabilityPoint(const std::vector<double>&)>& verdict, std::vector<std::vector<double>> axes,
                           const Progress& progress = {}, const Thresholds& thresholds = {}, const Thresholds& suspected = {});

}  // namespace gyromode
