#include "gyromode/modes/sparse_lowest.h"

#include "gyromode/base/error.h"
#include "gyromode/sparse/resting.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

constexpr Index more = 4;  // modes beyond those asked for, for a gap to end in

Index size_of(const SparseModes& modes) { return static_cast<Index>(modes.size()); }

}  // namespace

// Until that many have converged, without one between that has not.
sparse::MeasuredRoots SparseLowest::near_zero(Index wanted, const Window& range) const {
  sparse::Goal goal;
  goal.range = {0, range.b};
  goal.missing = wanted;
  goal.most_applied = most_applied(wanted);
  double last = 0;
  goal.enough = [&](const auto& inside) {
    const Index good = std::find_if(inside.begin(), inside.end(), [](const auto& e) { return !e.converged; }) - inside.begin();
    constexpr double beyond_error = 1 + 1e-6;
    last = good > 0 ? beyond_error * inside[static_cast<std::size_t>(std::min(good, wanted)) - 1].omega : 0;
    return wanted_if(good >= wanted, Window{0, last});
  };
  sparse::MeasuredRoots found = listable(searches_.about_zero(wanted), goal, progress_);
  while (!found.stopped && found.modes.size() > 1 && found.modes.back().omega > last) found.modes.pop_back();
  return found;
}

// At the widest gap where as many modes at rest are expected below as there are modes: μ = σ² + γσ between modes at
// rest, so that none of K − μM changes its sign before the next one at rest.
bool SparseLowest::close_at_rest(const SparseModes& low, Index wanted) const {
  if (balance_.index().negative > 0 || !system_.gyroscopic_bound() || size_of(low) <= wanted) return false;
  const double gamma = *system_.gyroscopic_bound();
  const Vector resting = sparse::resting_squares(system_, searches_.free(), low);
  const Index paired = searches_.free().pairs;  // of null(K), by G: they are modes that turn
  double best = 0, sigma = 0;
  Index below = 0;
  for (Index k = wanted; k < size_of(low); ++k) {
    const double from = low[static_cast<std::size_t>(k) - 1].omega, to = low[static_cast<std::size_t>(k)].omega;
    const double lower = from * (from + gamma), upper = to * to;
    const Index at_rest = std::count_if(resting.begin(), resting.end(), [&](double square) { return square < lower; });
    if (at_rest > k - paired) continue;
    const double next = k - paired < resting.size() ? resting(k - paired) : upper, gap = (next - lower) / lower;
    if (gap <= best) continue;
    best = gap;
    below = k;
    constexpr double inside = 0.05;
    sigma = from + inside * std::min(to - from, (std::sqrt(next + 0.25 * gamma * gamma) - 0.5 * gamma) - from);
  }
  if (below == 0) return false;
  progress_.stage("counts of the modes at rest");
  searches_.release_stiffness();  // the counts take as much again
  if (sparse::negative_at_rest(system_, searches_.groups(), sigma * (sigma + gamma)) != below + counts_.at_zero()) return false;
  counts_.know({0, sigma}, counts_.at_zero(), low);
  return true;
}

bool SparseLowest::counted_in_gap(const SparseModes& low, Index count) const {
  const double gap = size_of(low) > count ? gap_after(low, count) : 0;
  return gap > 0 && counts_.between(0, gap) == std::count_if(low.begin(), low.end(), [&](const auto& m) { return m.omega < gap; });
}

// Farther up until there are as many by count, and back where that was much too far.
SparseLowest::Found SparseLowest::by_windows(Index count, double start, double last) const {
  double below = 0, end = counts_.clear_of_roots(start);
  Index there = counts_.between(0, end);
  while (there <= count && end < last) {
    constexpr double least = 1.1, most = 2;
    below = end;
    const double wanted = static_cast<double>(count + more) / static_cast<double>(std::max<Index>(there, 1));
    end = std::min(counts_.clear_of_roots(end * std::clamp(wanted, least, most)), last);
    there = counts_.between(0, end);
  }
  constexpr int most_halvings = 40;
  for (int k = 0; k < most_halvings && there > 2 * count + most_at_one_shift; ++k) {
    const double middle = counts_.middle_of(below, end);
    const Index in_half = counts_.between(0, middle);
    (in_half > count ? end : below) = middle;
    if (in_half > count) there = in_half;
  }
  SparseWindows windows(searches_, counts_, progress_);
  SparseModes modes = windows.between(0, end, there);
  return {std::move(modes), end, windows.known_below()};
}

// About K; what is below the gap after them is counted. Where there are more than that, and of many, by windows whose
// ends are counted.
SparseLowest::Found SparseLowest::lowest(Index count, const Window& range) const {
  sparse::MeasuredRoots found = near_zero(std::min(count, most_at_one_shift) + more, range);
  SparseModes& low = found.modes;
  if (found.stopped) {
    if (low.empty()) throw Interrupted();
    const double end = low.back().omega + 2 * error_of(low.back());
    return {std::move(low), 0, end};
  }
  if (!balance_.index().closed) {  // counts say nothing of how many there are
    const double end = gap_after(low, std::min(count, size_of(low) - 1));
    if (end == 0) throw NotConverged("no mode near 0 has converged: ask for a window, which is searched from its ends");
    return {std::move(low), end, infinity};
  }
  const std::vector<sparse::Search::Expected> expected =
      low.empty() ? searches_.about_zero(count).look() : std::vector<sparse::Search::Expected>();
  if (low.empty() && expected.empty()) throw NotConverged("no mode near 0 was found: ask for a window, which is searched from its ends");
  const double start = low.empty() ? expected.front().omega : low.back().omega;
  if (count <= most_at_one_shift) {
    if (close_at_rest(low, count)) return {std::move(low), counts_.known().b, infinity};
    if (counted_in_gap(low, count)) return {std::move(low), 0, infinity};
  }
  return by_windows(count, start, range.b);
}

}  // namespace gyromode
