#pragma once

#include "gyromode/base/types.h"

#include <limits>

namespace gyromode {

/// A window of frequencies [a, b) in rad per unit of time; b may be infinite.
struct Window {
  double a = 0;
  double b = std::numeric_limits<double>::infinity();

  bool contains(double omega) const { return omega >= a && omega < b; }
  bool open() const { return b == std::numeric_limits<double>::infinity(); }
};

/// Throws InvalidArgument unless 0 ≤ a < b and a is finite.
void require_window(const Window& w);

}  // namespace gyromode
