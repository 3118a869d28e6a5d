#include "gyromode/motion/state.h"

#include "gyromode/base/error.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode {

void require_coordinates(const Vector& v, Index n, std::string_view what) {
  if (v.size() != n) throw InvalidArgument(fmt::format("{}: {} numbers where the system has {} coordinates", what, v.size(), n));
  if (!v.allFinite()) throw InvalidArgument(fmt::format("{}: not finite", what));
}

void require_time(double t) {
  if (!(t >= 0) || !std::isfinite(t)) throw InvalidArgument(fmt::format("a motion from initial conditions at t = 0 has no time {}", t));
}

}  // namespace gyromode
