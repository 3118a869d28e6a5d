#include "gyromode/motion/driven_sweep.h"

#include "gyromode/base/error.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

FrequencyPoint DrivenSweep::point(double at) const {
  const DrivenMode* on = nullptr;  // the pole there that the force drives most plainly
  for (const DrivenMode& m : poles) {
    if (std::abs(at - m.omega) <= m.error && (!on || m.driven > on->driven)) on = &m;
  }
  if (!on) return {at, solved(at), Driven::no, false, std::nullopt};
  if (on->driven == Driven::yes) return {at, ComplexVector(0), Driven::yes, false, on->participation};
  return {at, limit(at), on->driven, false, on->participation};
}

void DrivenSweep::show(const DrivenMode& pole, const Vector& grid, FrequencyResponse& r) const {
  for (const double away : {1e-2, 1e-3, 1e-4, 1e-5}) {
    for (const double at : {pole.omega * (1 - away), pole.omega * (1 + away)}) {
      if (at < grid(0) || at > grid(grid.size() - 1)) continue;
      r.points.push_back(point(at));
      r.points.back().added = true;
      r.points.back().participation = pole.participation;
    }
  }
}

FrequencyResponse DrivenSweep::over(const Vector& grid, bool resolve, const Progress& progress) const {
  FrequencyResponse r;
  r.modes = poles;
  for (const double at : grid) {
    r.interrupted = r.interrupted || progress.stopped();
    if (r.interrupted) break;
    r.points.push_back(point(at));
    progress.report(progress_of, static_cast<Index>(r.points.size()), grid.size());
  }
  if (r.interrupted && r.points.empty()) throw Interrupted();
  if (r.interrupted) return r;
  const DrivenMode* shown = nullptr;
  for (const DrivenMode& pole : poles) {
    if (!resolve || pole.driven != Driven::yes || !(pole.omega > 0)) continue;
    if (!shown || pole.omega - shown->omega > pole.error + shown->error) show(pole, grid, r);  // double poles once
    shown = &pole;
  }
  std::stable_sort(r.points.begin(), r.points.end(), [](const FrequencyPoint& a, const FrequencyPoint& b) { return a.omega < b.omega; });
  return r;
}

}  // namespace gyromode
