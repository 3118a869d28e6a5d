#include "gyromode/modes/sparse_windows.h"

#include <algorithm>

namespace gyromode {

namespace {

using sparse::RitzMode;

// Converged from one end on, without one between that has not.
template <class Iterator>
Index converged_from(Iterator first, Iterator last) {
  return std::find_if(first, last, [](const auto& e) { return !e.converged; }) - first;
}

// Those of `low` below a cut and of `high` above it, at the first cut between two modes that makes as many as expected.
std::optional<SparseModes> joined(const SparseModes& low, const SparseModes& high, double a, double b, Index expected) {
  std::vector<double> cuts{a, b};
  for (const SparseModes* side : {&low, &high}) {
    for (const RitzMode& m : *side) cuts.push_back(m.omega);
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    constexpr double apart = 1e-9;
    if (k > 0 && cuts[k + 1] - cuts[k] <= apart * cuts[k]) continue;
    const double cut = k == 0 ? a : 0.5 * (cuts[k] + cuts[k + 1]);
    const auto below = [cut](const RitzMode& m) { return m.omega < cut; };
    const auto lower = std::partition_point(low.begin(), low.end(), below), upper = std::partition_point(high.begin(), high.end(), below);
    if ((lower - low.begin()) + (high.end() - upper) != expected) continue;
    SparseModes all(low.begin(), lower);
    all.insert(all.end(), upper, high.end());
    return all;
  }
  return std::nullopt;
}

}  // namespace

SparseModes SparseWindows::about(double sigma, double a, double b, Index expected) {
  sparse::MeasuredRoots found = listable(*searches_.about(sigma, expected), all_of({a, b}, expected), progress_);
  if (found.stopped) return stopped_at(sigma == 0 ? std::move(found.modes) : SparseModes(), a);
  return std::move(found.modes);
}

// A mode beside the last one could still be missing: it ends there.
SparseModes SparseWindows::stopped_at(SparseModes modes, double a) {
  known_below_ = modes.empty() ? a : modes.back().omega + 2 * error_of(modes.back());
  return modes;
}

// Each end, a factorisation there for the counts, finds the half next to it.
SparseModes SparseWindows::from_both_ends(double a, double b, Index expected) {
  constexpr Index beyond = 1;
  Index wanted = (expected + 1) / 2 + beyond;
  const sparse::Goal all = all_of({a, b}, expected);
  sparse::Goal goal = all;
  goal.missing = wanted;
  // With half of them the rest is often near: it is given a little time.
  constexpr int more_looks = 2;
  int looks = 0;
  goal.enough = [&](const auto& inside) {
    const bool half = converged_from(inside.begin(), inside.end()) >= wanted && looks++ >= more_looks;
    return wanted_if(half || converged_in(inside) >= expected, goal.range);
  };
  const auto lower = searches_.about(a, expected);
  sparse::MeasuredRoots found = listable(*lower, goal, progress_);
  SparseModes low = std::move(found.modes);
  if (found.stopped) return stopped_at(std::move(low), a);
  if (static_cast<Index>(low.size()) == expected) return low;
  wanted = std::max<Index>(expected - static_cast<Index>(low.size()), 0) + beyond;
  goal.missing = wanted;
  goal.enough = [&](const auto& inside) {
    return wanted_if(converged_from(inside.rbegin(), inside.rend()) >= wanted || converged_in(inside) >= expected, goal.range);
  };
  found = listable(*searches_.about(b, expected), goal, progress_);
  const SparseModes high = std::move(found.modes);
  if (found.stopped) return stopped_at(std::move(low), a);
  if (std::optional<SparseModes> both = joined(low, high, a, b, expected)) return std::move(*both);
  // No gap to join them at, as where many are equal: all from one end.
  found = listable(*lower, all, progress_);
  low = std::move(found.modes);
  if (found.stopped) return stopped_at(std::move(low), a);
  return low.size() > high.size() ? low : high;
}

SparseModes SparseWindows::halves(double a, double b, double middle, int depth) {
  SparseModes all = searched(a, middle, counts_.between(a, middle), depth);
  if (stopped()) return all;
  for (RitzMode& m : searched(middle, b, counts_.between(middle, b), depth)) all.push_back(std::move(m));
  return all;
}

// Wide windows in parts; narrow ones from both ends, or from a shift of their own where that did not do. In halves
// where something is missing, as counts say in which.
SparseModes SparseWindows::searched(double a, double b, Index expected, int depth) {
  if (expected <= 0) return {};
  constexpr double narrowest = 1e-6;
  constexpr double near_a_mode = 1e-9;  // of the margin: a shift as near as that hides the others behind one root
  if (expected > most_at_one_shift && b - a > narrowest * b) return halves(a, b, counts_.middle_of(a, b), depth);
  const bool ends_serve = a > 0 && counts_.margin(a) > near_a_mode && counts_.margin(b) > near_a_mode;
  SparseModes all = a == 0 ? about(0, a, b, expected) : ends_serve ? from_both_ends(a, b, expected) : SparseModes();
  if (stopped() || static_cast<Index>(all.size()) == expected) return all;
  const double middle = counts_.middle_of(a, b);
  SparseModes other = about(middle, a, b, expected);
  if (stopped()) return other;
  if (other.size() > all.size()) all.swap(other);
  if (static_cast<Index>(all.size()) == expected || depth == 0) return all;
  other = halves(a, b, middle, depth - 1);
  if (stopped()) return other;
  return other.size() > all.size() ? other : all;
}

SparseModes SparseWindows::between(double a, double b, Index expected) {
  constexpr int halvings = 3;
  SparseModes all = searched(a, b, expected, halvings);
  if (stopped() || static_cast<Index>(all.size()) == expected || !searches_.leave_nothing_aside()) return all;
  SparseModes other = searched(a, b, expected, halvings);
  return other.size() > all.size() ? other : all;
}

}  // namespace gyromode
