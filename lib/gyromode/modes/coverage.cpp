#include "gyromode/modes/coverage.h"

#include "gyromode/modes/window_ends.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode {

namespace {

// The error bound of a root, and not less than what rounding of ω itself and a backward error of n ε leave open.
double open_error(const SolvedComponent& c, Index i) {
  const double eta = 4 * static_cast<double>(c.spectrum.size()) * std::numeric_limits<double>::epsilon();
  const double omega = c.spectrum.omega(i);
  const double error = std::max(c.assessment.error_bound(i), eta * c.assessment.sensitivity(i));
  return std::isfinite(error) ? std::max(error, 4 * std::numeric_limits<double>::epsilon() * omega) : 1e-6 * omega;
}

constexpr Index small = 64;  // factorisations of this order cost nothing to speak of

struct Cut {
  double omega = 0;
  Index expected = 0;  // n₋(H) there
  double width = 0;    // of the gap around it, relative
  bool between_signs = false;
};

// Gaps of the window in which no root can be, with what n₋(H) must be there.
std::vector<Cut> possible_cuts(const Frequencies& f, const Window& w, Index at_zero, Index direction) {
  std::vector<Cut> cuts;
  Index expected = at_zero;
  for (std::size_t i = 0; i + 1 < f.entries.size(); ++i) {
    const auto& e = f.entries[i];
    const auto& next = f.entries[i + 1];
    if (e.position >= 0) expected += direction * e.energy_sign;
    if (e.omega < w.a || next.omega >= w.b || next.position < 0) continue;
    const double from = e.omega + 4 * e.error;
    const double to = next.omega - 4 * next.error;
    if (!(to > from)) continue;
    cuts.push_back({0.5 * (from + to), expected, (to - from) / next.omega, e.position >= 0 && e.energy_sign != next.energy_sign});
  }
  return cuts;
}

// Boundaries between signs, narrowest first as the riskiest, and some of the widest gaps: each costs a factorisation, so a large system gets few. They are a second opinion on roots that were shown to exist one by one.
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

// A shape and frequency whose residual rounding does not explain are no mode, whatever the counts say: error bounds hold for eigenpairs. The solvers leave
// some 7 n ε at most. Where every root was shown to exist, by bounds that hold the residual, a shape may be a hundred times worse: with K near singular its small part is that ill determined.
std::optional<std::string> not_an_eigenpair(const SolvedSystem& s, const Frequencies& f, const Window& window) {
  for (const auto& e : f.entries) {
    if (e.position < 0 || !window.contains(e.omega)) continue;
    const SolvedComponent& c = s.components[static_cast<std::size_t>(e.component)];
    const double allowed = c.verdict.all_shown ? 3000 : 30;
    const double limit = allowed * static_cast<double>(std::max<Index>(c.spectrum.size(), 2)) * std::numeric_limits<double>::epsilon();
    const double residual = c.assessment.own_residual(e.position);
    if (!(residual <= limit)) return fmt::format("the root at ω = {:.6g} has the residual {:.2g}, above {:.2g}", e.omega, residual, limit);
  }
  return std::nullopt;
}

}  // namespace

Frequencies::Frequencies(const SolvedSystem& s) {
  for (std::size_t c = 0; c < s.components.size(); ++c) {
    const SolvedComponent& part = s.components[c];
    const Index component = static_cast<Index>(c);
    for (Index k = 0; k < part.spectrum.zero_pairs(); ++k) entries.push_back({0, 0, 0, component, -1 - k});
    for (Index k = 0; k < part.spectrum.omega.size(); ++k) {
      entries.push_back({part.spectrum.omega(k), open_error(part, k), part.verdict.energy_sign[static_cast<std::size_t>(k)], component, k});
    }
  }
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.omega < b.omega; });
}

Coverage coverage(const SolvedSystem& s, const Frequencies& f, const Window& requested, const WindowEnds& ends) {
  const Window& window = ends.window;
  Coverage c{CoverageStatus::not_counted, window, requested, 0, std::nullopt, ""};
  Index zero = 0;
  Index negative_energy = 0;
  Index undecided = 0;
  for (const auto& e : f.entries) {
    if (!window.contains(e.omega)) continue;
    ++c.found;
    if (e.position < 0) ++zero;
    else if (e.energy_sign < 0) ++negative_energy;
    else if (e.energy_sign == 0) ++undecided;
  }
  if (!s.index_balance().closed) {
    c.reason = "the index balance does not close: " + s.open_reason();
    return c;
  }
  if (ends.low.doubtful() || ends.high.doubtful()) {
    c.reason = "an endpoint of the window is on a root to rounding: move it";
    return c;
  }
  if (const auto doubt = not_an_eigenpair(s, f, window)) {
    c.status = CoverageStatus::incomplete;
    c.reason = *doubt;
    return c;
  }
  // In first order n₋(ωI − jG) falls from mode to mode; in second order it follows the energy signs.
  const Index direction = s.first_order ? -1 : 1;
  const Index signed_count = direction * (ends.high.negative - ends.low.negative);
  c.counted = signed_count + zero + 2 * negative_energy + undecided;  // an undecided pair is one + and one −
  if (*c.counted != c.found) {
    c.status = CoverageStatus::incomplete;
    c.reason = fmt::format("{} modes were found, the factorisations count {}", c.found, *c.counted);
    return c;
  }
  // Larger systems spend no factorisation on gaps where Parseval's identity has shown that no root is listed twice: with as many as there must be none is missing then.
  if (s.size > small && std::all_of(s.components.begin(), s.components.end(), [](const SolvedComponent& part) { return part.assessment.no_root_twice; })) {
    c.status = CoverageStatus::complete;
    return c;
  }
  const Index at_zero = window.a == 0 ? ends.low.negative : s.negative_at_zero();
  for (const Cut& cut : chosen_cuts(possible_cuts(f, window, at_zero, direction), s.size)) {
    const Inertia i = s.negative_at(cut.omega);
    if (i.doubtful() || i.negative == cut.expected) continue;
    c.status = CoverageStatus::incomplete;
    c.reason = fmt::format("below ω = {:.6g} the factorisations count {} fewer modes of positive than of negative energy than were found", cut.omega,
                           cut.expected - i.negative);
    return c;
  }
  c.status = CoverageStatus::complete;
  return c;
}

}  // namespace gyromode
