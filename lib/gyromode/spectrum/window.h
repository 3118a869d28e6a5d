#pragma once

#include "gyromode/base/types.h"

#include <limits>

namespace gyromode {

/// A window of frequencies [a, b) in rad per unit of time; b may be infinite.
struct Window {
  double a = 0;                                        ///< ≥ 0
  double b = std::numeric_limits<double>::infinity();  ///< > a

  bool contains(double omega) const { return omega >= a && omega < b; }       ///< whether ω is in [a, b)
  bool open() const { return b == std::numeric_limits<double>::infinity(); }  ///< whether b is infinite
};

/// Throws InvalidArgument unless 0 ≤ a < b and a is finite.
void require_window(const Window& w);

}  // namespace gyromode
