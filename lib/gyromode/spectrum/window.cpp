#include "gyromode/spectrum/window.h"

#include "gyromode/base/error.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode {

void require_window(const Window& w) {
  if (!(w.a >= 0) || !(w.b > w.a) || !std::isfinite(w.a)) {
    throw InvalidArgument(fmt::format("a window [a, b) needs 0 ≤ a < b: [{:.6g}, {:.6g}) is none", w.a, w.b));
  }
}

}  // namespace gyromode
