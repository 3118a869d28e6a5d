#include "gyromode/certificate/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

namespace gyromode {

namespace {

constexpr Index small = 64;  // factorisations of this order cost nothing to speak of

struct Cut {
  double omega = 0;
  Index expected = 0;  // n₋(H) there
  double width = 0;    // of the gap around it, relative
  bool between_signs = false;
};

// Gaps of the window in which no root can be, with what n₋(H) must be there.
std::vector<Cut> possible_cuts(const std::vector<CountedRoot>& all, const Window& w, Index at_zero, Index direction) {
  std::vector<Cut> cuts;
  Index expected = at_zero;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const CountedRoot& e = all[i];
    const CountedRoot& next = all[i + 1];
    if (!e.zero) expected += direction * e.energy_sign;
    if (e.omega < w.a || next.omega >= w.b || next.zero) continue;
    const double from = e.omega + 4 * e.error;
    const double to = next.omega - 4 * next.error;
    if (!(to > from)) continue;
    cuts.push_back({0.5 * (from + to), expected, (to - from) / next.omega, !e.zero && e.energy_sign != next.energy_sign});
  }
  return cuts;
}

// Boundaries between signs, narrowest first as the riskiest, and some of the widest gaps: each costs a factorisation,
// so a large system gets few. They are a second opinion on roots that were shown to exist one by one.
std::vector<Cut> chosen_cuts(const std::vector<Cut>& cuts, Index size) {
  const std::size_t most_boundaries = size <= small ? 64 : 2;
  const std::size_t most_gaps = size <= small ? 2 : 1;
  std::vector<Cut> boundaries;
  std::vector<Cut> gaps;
  for (const Cut& c : cuts) (c.between_signs ? boundaries : gaps).push_back(c);
  std::sort(boundaries.begin(), boundaries.end(), [](const Cut& a, const Cut& b) { return a.width < b.width; });
  std::sort(gaps.begin(), gaps.end(), [](const Cut& a, const Cut& b) { return a.width > b.width; });
  boundaries.resize(std::min(boundaries.size(), most_boundaries));
  gaps.resize(std::min(gaps.size(), most_gaps));
  boundaries.insert(boundaries.end(), gaps.begin(), gaps.end());
  return boundaries;
}

// The first cut at which the factorisations contradict the roots found, for people.
std::optional<std::string> contradiction(const CountedSpectrum& s, const std::vector<CountedRoot>& all, const Window& window, Index size) {
  for (const Cut& cut : chosen_cuts(possible_cuts(all, window, s.negative_at_zero(), s.direction()), size)) {
    const Inertia i = s.inertia_at(cut.omega);
    if (i.doubtful() || i.negative == cut.expected) continue;
    return fmt::format("below ω = {:.6g} the factorisations count {} fewer modes of positive than of negative energy than were found",
                       cut.omega * s.unit(), cut.expected - i.negative);
  }
  return std::nullopt;
}

}  // namespace

Index counted_in(const CountedSpectrum& s, const WindowEnds& ends) {
  const Index zero = ends.window.a == 0 ? s.zero_roots() : 0;
  return s.direction() * (ends.high.negative - ends.low.negative) + zero + s.missed_by_signs(ends.window);
}

Coverage coverage_of(const CountedSpectrum& s, const WindowEnds& ends, const std::vector<CountedRoot>& inside) {
  Coverage c;
  c.window = ends.window;
  c.found = static_cast<Index>(inside.size());
  if (!s.balance().closed) {
    c.reason = s.open_reason();
    return c;
  }
  if (ends.low.doubtful() || ends.high.doubtful()) {
    c.reason = "an endpoint of the window is on a root to rounding: move it";
    return c;
  }
  c.status = CoverageStatus::incomplete;
  if (const auto doubtful = std::find_if(inside.begin(), inside.end(), [](const CountedRoot& r) { return !r.doubt.empty(); });
      doubtful != inside.end()) {
    c.reason = doubtful->doubt;
    return c;
  }
  c.counted = counted_in(s, ends);
  if (*c.counted != c.found) {
    c.reason = fmt::format("{} modes were found, the counts at the ends of the window make {}", c.found, *c.counted);
    return c;
  }
  if (s.all_roots() && !s.isolated()) {
    if (const auto against = contradiction(s, *s.all_roots(), ends.window, ends.high.negative + ends.high.positive)) {
      c.reason = *against;
      return c;
    }
  }
  c.status = CoverageStatus::complete;
  return c;
}

}  // namespace gyromode
