#include "gyromode/motion/driven_sweep.h"

#include "gyromode/base/error.h"

#include <fmt/format.h>

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

std::vector<DrivenSweep::Wanted> DrivenSweep::wanted(const Vector& grid, bool resolve) const {
  std::vector<Wanted> all;
  for (const double at : grid) all.push_back({at, nullptr});
  const DrivenMode* shown = nullptr;
  for (const DrivenMode& pole : poles) {
    if (!resolve || pole.driven != Driven::yes || !(pole.omega > 0)) continue;
    const bool another = !shown || pole.omega - shown->omega > pole.error + shown->error;  // double poles once
    shown = &pole;
    if (!another) continue;
    for (const double away : {1e-2, 1e-3, 1e-4, 1e-5}) {
      for (const double at : {pole.omega * (1 - away), pole.omega * (1 + away)}) {
        if (at >= grid(0) && at <= grid(grid.size() - 1)) all.push_back({at, &pole});
      }
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Wanted& a, const Wanted& b) { return a.at < b.at; });
  return all;
}

FrequencyResponse DrivenSweep::over(const Vector& grid, bool resolve, const Progress& progress) const {
  FrequencyResponse r;
  r.modes = poles;
  const std::vector<Wanted> all = wanted(grid, resolve);
  for (const Wanted& w : all) {
    r.interrupted = progress.stopped();
    if (r.interrupted) break;
    r.points.push_back(point(w.at));
    if (w.beside) {
      r.points.back().added = true;
      r.points.back().participation = w.beside->participation;
    }
    progress.report(progress_of, static_cast<Index>(r.points.size()), static_cast<Index>(all.size()));
  }
  if (r.interrupted && r.points.empty()) throw Interrupted();
  return r;
}

void require_sweep(const Vector& force, const Vector& grid, Index n) {
  if (force.size() != n) throw InvalidArgument(fmt::format("force: {} numbers where the system has {} coordinates", force.size(), n));
  if (!force.allFinite() || !grid.allFinite()) throw InvalidArgument("force and grid must be finite");
  for (Index k = 0; k < grid.size(); ++k) {
    if (!(grid(k) >= 0)) throw InvalidArgument(fmt::format("grid: a frequency of {:g} where ω ≥ 0 was expected", grid(k)));
    if (k > 0 && !(grid(k) > grid(k - 1)))
      throw InvalidArgument(fmt::format("grid: {:.17g} after {:.17g} where ascending frequencies were expected", grid(k), grid(k - 1)));
  }
}

std::vector<DrivenMode> within(const Vector& grid, std::vector<DrivenMode> poles) {
  std::erase_if(poles, [&](const DrivenMode& m) { return m.omega + m.error < grid(0) || m.omega - m.error > grid(grid.size() - 1); });
  return poles;
}

}  // namespace gyromode
