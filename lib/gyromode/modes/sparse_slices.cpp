#include "gyromode/modes/sparse_slices.h"

#include "gyromode/sparse/resting.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

using Expected = sparse::Search::Expected;

constexpr double beside = 1e-6;
constexpr Index most_beyond = 2;  // modes beyond an end of the window

// Those around a shift that have converged, without one between that has not: the first, and the one after the last.
std::pair<std::size_t, std::size_t> converged_about(double sigma, const std::vector<Expected>& all) {
  const auto above = std::find_if(all.begin(), all.end(), [&](const Expected& e) { return e.omega >= sigma; });
  const auto last = std::find_if(above, all.end(), [](const Expected& e) { return !e.converged; });
  auto first = above;
  while (first != all.begin() && std::prev(first)->converged) --first;
  return {static_cast<std::size_t>(first - all.begin()), static_cast<std::size_t>(last - all.begin())};
}

// A place between two modes of a slice, near one of its ends, where they are farther apart than their errors.
std::optional<double> cut_near_end(const SparseModes& modes, bool upper) {
  constexpr double apart = 1e-9;
  const std::size_t n = modes.size();
  for (std::size_t k = 1; k < n; ++k) {
    const auto &from = modes[upper ? n - 1 - k : k - 1], &to = modes[upper ? n - k : k];
    if (to.omega - from.omega > apart * to.omega + 4 * (error_of(from) + error_of(to))) return 0.5 * (from.omega + to.omega);
  }
  return std::nullopt;
}

Index number_between(const SparseModes& modes, double a, double b) {
  return std::count_if(modes.begin(), modes.end(), [&](const auto& m) { return m.omega >= a && m.omega < b; });
}

}  // namespace

bool SparseSlices::serve(const Window& window) const {
  return window.a > 0 && !window.open() && balance_.index().closed && balance_.index().negative == 0 && !system_.singular_mass() &&
         system_.gyroscopic_bound();
}

// About the shift in the middle of ω², from which both ends are equally far, until a mode beyond either end is known,
// or as many as one shift is asked for.
std::optional<SparseSlices::Slice> SparseSlices::slice(const Window& window) {
  Slice s;
  const double middle = std::sqrt(0.5 * (window.a * window.a + window.b * window.b));
  s.shift = middle;
  constexpr int attempts = 8;
  for (int k = 0; k < attempts && counts_.at(s.shift).doubtful(); ++k) s.shift = middle * (1 - 1e-5 * std::exp2(k));
  if (counts_.at(s.shift).doubtful() || counts_.at(s.shift).positive <= searches_.free().t.cols()) return std::nullopt;  // all are below
  s.below = counts_.at(s.shift).negative - counts_.at_zero();
  const Index copies = searches_.groups().partition ? 1 : 2;  // of every root, as the operator has it
  sparse::Goal goal;
  goal.range = {0, infinity};
  goal.missing = most_at_one_shift;
  goal.most_applied = most_applied(most_at_one_shift);
  goal.enough = [&](const std::vector<Expected>& all) -> std::optional<Window> {
    const auto [first, last] = converged_about(s.shift, all);
    if (first == last) return std::nullopt;
    const auto below = static_cast<Index>(
        std::count_if(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(), [&](const Expected& e) { return e.omega < s.shift; }));
    s.lowest = below == copies * s.below;
    double from = all[first].omega, to = all[last - 1].omega;
    const bool both = (s.lowest || from < window.a * (1 - beside)) && to > window.b * (1 + beside);
    if (!both && static_cast<Index>(last - first) < copies * most_at_one_shift) return std::nullopt;
    Index below_window = 0, above_window = 0;  // one or two of them leave a gap beyond either end
    for (std::size_t k = last; k-- > first;) {
      if (all[k].omega < window.a * (1 - beside) && below_window++ < copies * most_beyond) from = all[k].omega;
    }
    for (std::size_t k = first; k < last; ++k) {
      if (all[k].omega > window.b * (1 + beside) && above_window++ < copies * most_beyond) to = all[k].omega;
    }
    return Window{from * (1 - beside), to * (1 + beside)};
  };
  const std::unique_ptr<sparse::Search> search = searches_.about(s.shift, most_at_one_shift);
  sparse::MeasuredRoots found = listable(*search, goal, progress_);
  if (found.stopped) {
    const std::vector<Expected> all = search->look();
    const auto [first, last] = converged_about(s.shift, all);
    if (first == last) return s;
    found = search->found({all[first].omega * (1 - beside), all[last - 1].omega * (1 + beside)});
  }
  s.modes = std::move(found.modes);
  return s;
}

// What a slice leaves of the window on either side is covered by others.
SparseSlices::End SparseSlices::cover(const Window& window, int depth) {
  std::optional<Slice> s = slice(window);
  if (!s) return End::failed;
  const std::optional<double> low = s->lowest ? 0 : cut_near_end(s->modes, false), high = cut_near_end(s->modes, true);
  const bool reaches_down = s->lowest || (!s->modes.empty() && s->modes.front().omega < window.a),
             reaches_up = !s->modes.empty() && s->modes.back().omega > window.b;
  const auto place = std::upper_bound(slices_.begin(), slices_.end(), s->shift, [](double w, const Slice& t) { return w < t.shift; });
  slices_.insert(place, std::move(*s));
  if (progress_.stopped()) return End::stopped;
  for (const auto& [covered, left] :
       {std::pair(reaches_down, low ? Window{window.a, *low} : window), std::pair(reaches_up, high ? Window{*high, window.b} : window)}) {
    if (covered) continue;
    if (depth == 0 || !low || !high || !(left.b > left.a)) return End::failed;
    const End end = cover(left, depth - 1);
    if (end != End::reached) return end;
  }
  return End::reached;
}

// Each slice up to a gap in what it shares with the next one.
SparseModes SparseSlices::joined() const {
  SparseModes all;
  for (const Slice& s : slices_) {
    const std::optional<double> cut = all.empty() ? std::nullopt : cut_near_end(s.modes, false);
    if (cut) std::erase_if(all, [&](const auto& m) { return m.omega >= *cut; });
    for (const sparse::RitzMode& m : s.modes) {
      if (!cut || m.omega >= *cut) all.push_back(m);
    }
  }
  return all;
}

// Between shifts by their counts; from the outermost ones to the widest gap beyond the ends of the window by modes at
// rest: K − (ω² + γω)M ≤ H(ω) ≤ K − (ω² − γω)M, and every mode found makes n₋(H) one larger.
void SparseSlices::prove(const Window& window, const SparseModes& all) {
  for (std::size_t k = 1; k < slices_.size(); ++k) {
    if (number_between(all, slices_[k - 1].shift, slices_[k].shift) != slices_[k].below - slices_[k - 1].below) return;
  }
  const double first = slices_.front().shift, last = slices_.back().shift, gamma = *system_.gyroscopic_bound();
  const Index zero = counts_.at_zero(), at_first = zero + slices_.front().below, at_last = zero + slices_.back().below;
  Window known{first, last};
  Index negative = at_first;
  constexpr double wide = 0.5, inside = 0.05;  // a gap of γ is enough for certain
  double low = 0, low_gap = 0, high = 0, high_gap = 0;
  for (std::size_t k = 1; k < all.size(); ++k) {
    const double from = all[k - 1].omega, to = all[k].omega, edge = inside * (to - from);
    if (from < window.a && std::min(to - edge, window.a) - from > low_gap) low = std::min(to - edge, window.a), low_gap = low - from;
    if (to > window.b && to - std::max(from + edge, window.b) > high_gap) high = std::max(from + edge, window.b), high_gap = to - high;
  }
  progress_.stage("counts of the modes at rest");
  searches_.release_stiffness();  // the counts take as much again
  const auto at_rest = [&](double mu) { return sparse::negative_at_rest(system_, searches_.groups(), mu); };
  if (slices_.front().lowest && number_between(all, 0, first) == slices_.front().below) {
    known.a = 0;
    negative = zero;
  } else if (low_gap > wide * gamma && at_rest(low * (low - gamma)) == at_first - number_between(all, low, first)) {
    known.a = low;
    negative = at_first - number_between(all, low, first);
  }
  if (high_gap > wide * gamma && at_rest(high * (high + gamma)) == at_last + number_between(all, last, high)) known.b = high;
  counts_.know(known, negative, all);
}

std::optional<SparseSlices::Found> SparseSlices::about_middles(const Window& window) {
  constexpr int depth = 6;
  const End end = cover(window, depth);
  if (end == End::failed) return std::nullopt;
  if (end == End::stopped) {
    const auto most =
        std::max_element(slices_.begin(), slices_.end(), [](const Slice& a, const Slice& b) { return a.modes.size() < b.modes.size(); });
    Found f{std::move(most->modes), Window{window.a, window.a}};
    const std::optional<double> low = cut_near_end(f.modes, false), high = cut_near_end(f.modes, true);
    if (low && high && *low < *high) f.stopped = {*low, *high};
    return f;
  }
  Found f{joined(), std::nullopt};
  prove(window, f.modes);
  return f;
}

}  // namespace gyromode
