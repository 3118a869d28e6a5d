#include "gyromode/sweep/solved_spins.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace gyromode {

namespace {

constexpr Index more_modes = 4;  // beyond those asked for, so that the space serves up to the last

bool vibrates(const Mode& m) { return m.kind != ModeKind::rigid_body && m.omega > 0; }

// The lowest so many of a complete result, and what coincides with the last of them.
void keep_lowest(Index lowest, ModesResult& r) {
  constexpr double apart = 1e-9;
  std::size_t kept = 0;
  for (Index vibrations = 0; kept < r.modes.size(); ++kept) {
    if (!vibrates(r.modes[kept])) continue;
    if (vibrations >= lowest && r.modes[kept].omega - r.modes[kept - 1].omega > apart * r.modes[kept].omega) break;
    ++vibrations;
  }
  if (kept == r.modes.size() || r.coverage.status != CoverageStatus::complete) return;
  r.coverage.window.b = 0.5 * (r.modes[kept - 1].omega + r.modes[kept].omega);
  r.modes.resize(kept);
  r.coverage.found = 0;
  for (const Mode& m : r.modes) r.coverage.found += m.multiplicity;
  r.coverage.counted = r.coverage.found;
}

ComplexMatrix shapes_of(const ModesResult& r) {
  ComplexMatrix all(r.modes.empty() ? 0 : r.modes.front().shape.size(), static_cast<Index>(r.modes.size()));
  for (std::size_t k = 0; k < r.modes.size(); ++k) all.col(static_cast<Index>(k)) = r.modes[k].shape;
  return all;
}

// The largest distance, relative, of a frequency found to the nearest of the projection.
double departure(const ModesResult& found, const ModesResult& projected) {
  double most = 0;
  for (const Mode& m : found.modes) {
    if (!vibrates(m)) continue;
    double nearest = 1;
    for (const Mode& p : projected.modes) nearest = std::min(nearest, std::abs(p.omega - m.omega) / m.omega);
    most = std::max(most, nearest);
  }
  return most;
}

double highest_of(const ModesResult& r) { return r.modes.empty() || !(r.modes.back().omega > 0) ? 1 : r.modes.back().omega; }

}  // namespace

SolvedSpins::SolvedSpins(const LargeFamily& family, const CampbellOptions& o) : family_(family), lowest_(o.lowest) {
  asked_.shapes = true;
  asked_.window.b = o.below;
  if (o.lowest) asked_.lowest = *o.lowest + more_modes;
  asked_.progress.stop = o.progress.stop;
}

void SolvedSpins::solve(double spin) {
  At now;
  now.result = family_.modes(spin, asked_);
  if (asked_.progress.stopped()) return;
  now.turn = static_cast<Index>(at_.size());
  if (!projection_) projection_.emplace(family_, highest_of(now.result));
  if (at_.size() >= 2 && projection_->order() > 0) {
    ModesOptions same = asked_;
    same.shapes = false;
    same.progress = {};
    same.method = Method::general;
    now.off = departure(now.result, find_modes(projection_->family().at(spin), same));
  }
  if (!now.result.modes.empty()) projection_->add(shapes_of(now.result));
  if (lowest_) keep_lowest(*lowest_, now.result);
  at_.emplace(spin, std::move(now));
}

std::optional<double> SolvedSpins::worst_middle(double enough) const {
  std::optional<double> middle;
  for (auto a = at_.begin(); a != at_.end() && std::next(a) != at_.end(); ++a) {
    const auto b = std::next(a);
    if (off_between(a, b) <= enough) continue;
    enough = off_between(a, b);
    middle = 0.5 * (a->first + b->first);
  }
  return middle;
}

void SolvedSpins::finish() {
  for (auto& [spin, at] : at_) {
    if (at.result.modes.empty()) continue;
    const ComplexMatrix y = projection_->coordinates(shapes_of(at.result));
    for (std::size_t k = 0; k < at.result.modes.size(); ++k) at.result.modes[k].shape = y.col(static_cast<Index>(k));
  }
}

ModesResult SolvedSpins::modes(double spin, const ModesOptions& options) const {
  const auto above = at_.lower_bound(spin);
  if (above != at_.end() && above->first == spin) return above->second.result;
  if (projection_->order() == 0) return at_.begin()->second.result;  // no modes at any spin
  ModesOptions o = options;
  o.method = Method::general;  // a hidden symmetry takes longer to find than all modes
  ModesResult r = find_modes(projection_->family().at(spin), o);
  const double off = above == at_.end() || above == at_.begin() ? 1 : off_between(std::prev(above), above);
  for (Mode& m : r.modes) m.error_bound += off * m.omega;
  return r;
}

}  // namespace gyromode
