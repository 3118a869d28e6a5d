#include "gyromode/modes/spacecraft_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace gyromode {

Window in_units(const Window& w, double unit, const Window& requested) {
  return {w.a == requested.a / unit ? requested.a : w.a * unit, w.b == requested.b / unit ? requested.b : w.b * unit};
}

Window lowest_window(const SpacecraftSolution& s, Index lowest, const Window& requested) {
  const bool infinite = s.impedance().continuous();
  if (!infinite && lowest >= s.impedance().size()) return {requested.a, std::min(requested.b, s.above_all())};
  const Index before = s.roots().below(requested.a);
  const double highest = std::min(requested.b, infinite ? std::numeric_limits<double>::infinity() : s.above_all());
  const double reach = s.spacecraft().cables().empty() ? std::numeric_limits<double>::infinity() : farthest_over_spin;
  double b = std::max(2.0, 2 * requested.a);
  const auto found = [&] { return s.roots().below(b) - before; };
  for (; found() < lowest + 3 && b < highest && b < reach; b *= 1.5) {}  // the tilt is among them, and one more shows the gap
  if (b >= reach && b < highest) {
    b = reach;
    if (found() - 1 < lowest) {  // without the tilt
      throw std::invalid_argument(fmt::format("{} modes were asked for, and {} are within reach: fields of wires are followed up to {:.0e} times the spin, {:.6g} rad/s", lowest, std::max<Index>(found() - 1, 0),
                                              farthest_over_spin, farthest_over_spin * s.unit()));
    }
  }
  const std::vector<Root> all = s.roots_around(requested.a, std::min(b, requested.b));
  Index seen = 0;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (all[i].omega < requested.a) continue;
    if (!SpacecraftSolution::is_tilt(all[i])) ++seen;
    const double from = all[i].omega + 4 * open_error(all[i]), to = all[i + 1].omega - 4 * open_error(all[i + 1]);
    if (seen >= lowest && to > from) return {requested.a, std::min(0.5 * (from + to), requested.b)};
  }
  return {requested.a, std::min(b, requested.b)};
}

Coverage coverage_of(const SpacecraftSolution& s, const Window& requested, const Window& window, const std::vector<Root>& inside) {
  Coverage c;
  c.requested = requested;
  c.window = window;
  const Index zeros = window.a == 0 ? s.zeros() : 0;
  c.found = static_cast<Index>(inside.size()) + zeros;
  if (!s.roots().closed()) {
    c.reason = s.roots().at_zero().doubtful ? "the static stiffness is singular to rounding" : "the index balance does not close: modes of negative energy or growing ones are missing";
    return c;
  }
  if ((window.a > 0 && s.roots().doubtful_at(window.a)) || s.roots().doubtful_at(window.b)) {
    c.reason = "an end of the window is on a root to rounding: move it";
    return c;
  }
  for (const Root& r : inside) {
    if (std::isfinite(r.error) && r.omega > 0) continue;
    c.status = CoverageStatus::incomplete;
    c.reason = fmt::format("the root near ω = {:.6g} did not settle", r.omega * s.unit());
    return c;
  }
  c.counted = s.roots().count(window.a, window.b) + zeros;
  c.status = *c.counted == c.found ? CoverageStatus::complete : CoverageStatus::incomplete;
  if (c.status == CoverageStatus::incomplete) c.reason = fmt::format("{} modes were found, the exact impedance counts {}", c.found, *c.counted);
  return c;
}

}  // namespace gyromode
