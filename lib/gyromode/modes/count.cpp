#include "gyromode/modes/count.h"

#include "gyromode/modes/components.h"
#include "gyromode/modes/window_ends.h"

#include <limits>

namespace gyromode {

namespace {

CountResult counted(const SolvedSystem& s, const Window& requested) {
  const Frequencies f(s);
  const WindowEnds ends = ends_of(s, f, requested);
  const Window& window = ends.window;
  const Coverage c = coverage(s, f, requested, ends);
  CountResult r;
  r.window = window;
  r.requested = requested;
  r.negative = {ends.low.negative, ends.high.negative};
  r.signed_count = (s.first_order ? -1 : 1) * (ends.high.negative - ends.low.negative);
  for (const auto& e : f.entries) {
    if (e.position < 0 && window.contains(0)) ++r.zero;
  }
  if (ends.low.doubtful() || ends.high.doubtful()) {
    r.status = CountStatus::doubtful;
  } else if (!c.counted) {
    r.status = CountStatus::signed_only;
  } else {
    r.count = c.counted;
    r.status = c.status == CoverageStatus::complete ? CountStatus::exact : CountStatus::doubtful;
  }
  return r;
}

}  // namespace

std::string_view word(CountStatus status) {
  switch (status) {
    case CountStatus::exact: return "exact";
    case CountStatus::signed_only: return "signed_only";
    default: return "doubtful";
  }
}

CountResult count_modes(const System& system, const Window& window) {
  require_window(window);
  return counted(solve_components(system, dense::Method::automatic), window);
}

CountResult count_modes(const FirstOrderSystem& system, const Window& window) {
  require_window(window);
  return counted(solve_components(system, dense::Method::automatic), window);
}

}  // namespace gyromode
