#include "gyromode/models/critical_in_fixed_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode {

namespace {

// Whether a motion at ω in turning axes has a part at `wanted` in fixed ones (both in speeds, of the speed 1).
bool has_part(const CriticalSpeed& c, double wanted, const std::vector<OrbitCoordinates>& places) {
  const std::vector<FixedAxesPart> parts = in_fixed_axes(c.shape, c.multiple, 1, places);
  return std::any_of(parts.begin(), parts.end(), [&](const FixedAxesPart& p) { return p.omega == wanted; });
}

}  // namespace

CriticalSpeeds critical_speeds_from_turning_axes(const ModelKind& model, const CriticalOptions& options) {
  const std::vector<OrbitCoordinates> places = model.orbits();
  const double m = options.order;
  CriticalSpeeds all;
  all.order = m;
  all.in_fixed_axes = true;
  Coverage& whole = all.coverage;
  const auto add = [&](double multiple, Whirl whirl, bool first) {
    CriticalOptions o = options;
    o.order = multiple;
    o.lowest.reset();
    CriticalSpeeds found = model.critical_speeds(o);
    all.not_physical += found.not_physical;
    Index left_out = 0;
    for (CriticalSpeed& c : found.speeds) {
      // At rest in fixed axes (m = 0) the part that goes against the axes stands still.
      const double wanted = whirl == Whirl::forward ? 1 + (m < 1 ? -multiple : multiple) : 1 - multiple;
      if (!places.empty() && !has_part(c, wanted, places)) {
        ++left_out;
        continue;
      }
      c.whirl = m == 0 ? std::optional<Whirl>() : whirl;
      all.speeds.push_back(std::move(c));
    }
    all.other_way += left_out;
    found.coverage.found -= left_out;
    if (found.coverage.counted) *found.coverage.counted -= left_out;
    if (first) {
      whole = found.coverage;
      return;
    }
    whole.window.b = std::min(whole.window.b, found.coverage.window.b);
    whole.found += found.coverage.found;
    whole.counted = whole.counted && found.coverage.counted ? std::optional(*whole.counted + *found.coverage.counted) : std::nullopt;
    if (found.coverage.status != CoverageStatus::complete && whole.status == CoverageStatus::complete) {
      whole.status = found.coverage.status;
      whole.reason = found.coverage.reason;
    }
  };
  add(std::abs(m - 1), Whirl::forward, true);
  if (m > 0) add(m + 1, Whirl::backward, false);
  std::stable_sort(all.speeds.begin(), all.speeds.end(), [](const CriticalSpeed& a, const CriticalSpeed& b) { return a.speed < b.speed; });
  if (options.lowest && static_cast<Index>(all.speeds.size()) > *options.lowest) {
    all.speeds.resize(static_cast<std::size_t>(*options.lowest));
    whole.window.b = std::nextafter(all.speeds.back().speed, std::numeric_limits<double>::infinity());
    whole.found = *options.lowest;
    if (whole.status == CoverageStatus::complete) whole.counted = *options.lowest;
  }
  return all;
}

}  // namespace gyromode
