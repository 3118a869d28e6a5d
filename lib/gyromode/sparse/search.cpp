#include "gyromode/sparse/search.h"

#include <algorithm>

namespace gyromode::sparse {

bool converged(const RitzMode& m) {
  constexpr double enough = 3e-11;
  return m.residual <= enough;
}

namespace {

constexpr int steps_between_looks = 3;
constexpr int quiet_looks = 2;   // with all in range converged, before other shapes are tried
constexpr int most_refused = 4;  // looks at what should have converged and has not, to what is asked of a result
constexpr Index least_width = 8, most_width = 32;

Index number_converged(const Search::Found& f) {
  return std::count_if(f.modes.begin(), f.modes.end(), [](const RitzMode& m) { return converged(m); });
}

// What has converged from the beginning of the range on, without one between that has not.
Search::Found found_so_far(const Search& search, const Window& range) {
  constexpr double beyond_error = 1 + 1e-6;
  double last = 0;
  for (const Search::Expected& e : search.look()) {
    if (!range.contains(e.omega)) continue;
    if (!e.converged) break;
    last = beyond_error * e.omega;
  }
  Search::Found f;
  if (last > range.a) f = search.found({range.a, std::min(last, range.b)});
  f.stopped = true;
  return f;
}

}  // namespace

Search::Found search_for(Search& search, const Goal& goal, const Progress& progress) {
  int quiet = 0, refused = 0, refreshed_for_nothing = 0;
  Index best = -1;
  const Index before = search.applied();
  for (int step = 1;; ++step) {
    const bool more = search.step();
    if (progress.stopped()) return found_so_far(search, goal.range);
    const bool last = search.applied() - before >= goal.most_applied;
    if (more && !last && step % steps_between_looks != 0) continue;
    std::vector<Search::Expected> inside;
    for (const Search::Expected& e : search.look()) {
      if (goal.range.contains(e.omega)) inside.push_back(e);
    }
    const Index good = std::count_if(inside.begin(), inside.end(), [](const auto& e) { return e.converged; });
    progress.report("modes", good, std::max(goal.missing, good));
    if (const std::optional<Window> now = goal.enough(inside)) {
      Search::Found f = search.found(*now);
      const Index all = std::count_if(inside.begin(), inside.end(), [&](const auto& e) { return e.converged && now->contains(e.omega); });
      if ((goal.accepted ? goal.accepted(f) : number_converged(f) >= all) || last) return f;
      if (!goal.accepted && refused++ >= most_refused) return f;
    }
    if (last) return search.found(goal.range);
    const bool settled = good > 0 && good == static_cast<Index>(inside.size()) && good == best;
    quiet = settled ? quiet + 1 : 0;
    best = std::max(best, good);
    if (more && quiet < quiet_looks) continue;
    if (!more && refreshed_for_nothing++ > 1) return search.found(goal.range);
    if (more) refreshed_for_nothing = 0;
    quiet = 0;
    search.refresh(std::clamp(goal.missing - good, least_width, most_width));
  }
}

}  // namespace gyromode::sparse
