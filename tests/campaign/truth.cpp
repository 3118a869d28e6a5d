#include "campaign/truth.h"

#include "gyromode/structure/structure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode::support {

namespace {

constexpr double epsilon = 2.220446049250313e-16;

// The bound of a claim, and what writing the truth and the answer as doubles may differ by.
double allowed(double bound, double value) { return bound + 2 * epsilon * std::abs(value); }

void note(Faults& f, bool& flag, const std::string& what) {
  flag = true;
  f.text += (f.text.empty() ? "" : "; ") + what;
}

Index true_modes_in(const Truth& t, const Window& w) {
  Index count = w.a == 0 ? t.zero_pairs : 0;
  for (const auto& m : t.modes) count += w.contains(m.omega) ? 1 : 0;
  return count;
}

void compare_modes(const ModesResult& r, const Truth& t, Faults& f, std::vector<double>* tightness) {
  std::vector<Truth::Root> expected;
  if (r.coverage.window.a == 0) expected.assign(static_cast<std::size_t>(t.zero_pairs), {0, 0});
  for (const auto& m : t.modes) {
    if (r.coverage.window.contains(m.omega)) expected.push_back(m);
  }
  if (expected.size() != r.modes.size())
    return note(f, f.false_complete, fmt::format("complete with {} modes, true {}", r.modes.size(), expected.size()));
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Mode& m = r.modes[i];
    const double error = std::abs(m.omega - expected[i].omega);
    if (!(error <= allowed(m.error_bound, m.omega)))
      note(f, f.mode_outside_bound, fmt::format("mode {:.17g}, true {:.17g}, bound {:.3g}", m.omega, expected[i].omega, m.error_bound));
    if (tightness && error > epsilon * m.omega) tightness->push_back(m.error_bound / error);
    // Signs of roots that stand alone; of a cluster their sum.
    std::size_t last = i;
    while (last + 1 < expected.size() && expected[last + 1].omega - expected[last].omega <= 1e-9 * expected[last].omega + 4 * m.error_bound)
      ++last;
    if (i > 0 && expected[i].omega - expected[i - 1].omega <= 1e-9 * expected[i].omega + 4 * r.modes[i - 1].error_bound) continue;
    int ours = 0, truth = 0;
    for (std::size_t k = i; k <= last; ++k) {
      ours += r.modes[k].energy_sign;
      truth += expected[k].sign;
    }
    if (ours != truth)
      note(f, f.wrong_sign, fmt::format("signs of {} modes at {:.17g} add up to {}, true {}", last - i + 1, m.omega, ours, truth));
  }
}

void compare_growth(const ModesResult& r, const Truth& t, Faults& f) {
  for (const UnstableMode& u : r.unstable) {
    double nearest = std::numeric_limits<double>::infinity();
    const double bound = allowed(u.error_bound, std::hypot(u.growth_rate, u.omega));
    for (const auto& [sigma, omega] : t.flutter) nearest = std::min(nearest, std::hypot(u.growth_rate - sigma, u.omega - omega));
    for (const double sigma : t.divergence) nearest = std::min(nearest, std::hypot(u.growth_rate - sigma, u.omega));
    if (!(nearest <= bound))
      note(f, f.growth_outside_bound,
           fmt::format("growth {:.17g} + {:.17g}j, nearest true root {:.3g} away, bound {:.3g}", u.growth_rate, u.omega, nearest,
                       u.error_bound));
  }
}

// An end may be moved where a true mode is near: never past what is 1e-4 of it.
void compare_window(const ModesResult& r, const Truth& t, Faults& f) {
  const auto near = [&](double end, double moved) {
    return std::any_of(t.modes.begin(), t.modes.end(), [&](const Truth::Root& m) {
      return m.omega >= std::min(end, moved) * (1 - 1e-3) && m.omega <= std::max(end, moved) * (1 + 1e-3);
    });
  };
  for (const auto& [asked, used] :
       {std::pair(r.coverage.requested.a, r.coverage.window.a), std::pair(r.coverage.requested.b, r.coverage.window.b)}) {
    if (asked == used) continue;
    if (!near(asked, used) || std::abs(used - asked) > 1e-2 * asked)
      note(f, f.window_moved, fmt::format("end {:.17g} moved to {:.17g}", asked, used));
  }
}

}  // namespace

Stability stability_of(reference::Spectrum::Verdict v) {
  switch (v) {
    case reference::Spectrum::Verdict::stable: return Stability::stable;
    case reference::Spectrum::Verdict::gyroscopically_stabilised: return Stability::gyroscopically_stabilised;
    case reference::Spectrum::Verdict::marginal: return Stability::marginal;
    default: return Stability::unstable;
  }
}

Truth truth_of(const HostileSystem& h) {
  Truth t;
  const System base(h.base.mass, h.base.gyroscopic, h.base.stiffness);
  for (const Component& c : analyse(base, HiddenSearch::never).components) {
    const auto& at = c.coordinates;
    const reference::Spectrum s = reference::spectrum(h.base.mass(at, at), h.base.gyroscopic(at, at), h.base.stiffness(at, at));
    t.zero_pairs += s.zero_roots / 2;
    for (std::size_t i = 0; i < s.omega.size(); ++i) t.modes.push_back({h.time_unit * s.omega[i], s.energy_sign[i]});
    for (const double sigma : s.divergence) t.divergence.push_back(h.time_unit * sigma);
    for (const auto& [sigma, omega] : s.flutter) t.flutter.emplace_back(h.time_unit * sigma, h.time_unit * omega);
    t.stability = std::max(t.stability, stability_of(s.verdict));
    t.distance = std::min(t.distance, s.distance);
  }
  std::stable_sort(t.modes.begin(), t.modes.end(), [](const auto& a, const auto& b) { return a.omega < b.omega; });
  std::sort(t.divergence.begin(), t.divergence.end());
  std::sort(t.flutter.begin(), t.flutter.end());
  for (std::size_t i = 0; i + 1 < t.modes.size(); ++i) {  // opposite roots of two components
    const bool meet = t.modes[i].sign * t.modes[i + 1].sign < 0 && t.modes[i + 1].omega - t.modes[i].omega <= 1e-14 * t.modes[i].omega;
    if (meet && t.stability < Stability::marginal) t.stability = Stability::marginal;
  }
  return t;
}

namespace {

// An undecided pair, two modes of sign 0, may be two modes, a defective root, or flutter that a backward error can
// undo: the program says so and does not pick a side. True flutter whose growth is within the bound of such a pair, and
// below 1e-6 of its frequency, counts as that pair.
Truth with_undecided_pairs(const ModesResult& r, Truth t) {
  const auto is_pair = [&](const std::pair<double, double>& root) {
    const auto [sigma, omega] = root;
    const auto found = std::count_if(r.negative_modes.begin(), r.negative_modes.end(), [&, sigma = sigma, omega = omega](const Mode& m) {
      return m.energy_sign == 0 && std::abs(m.omega - omega) <= m.error_bound && sigma <= m.error_bound && sigma <= 1e-6 * omega;
    });
    return found >= 2;
  };
  for (const auto& root : t.flutter) {
    if (is_pair(root)) t.modes.insert(t.modes.end(), 2, {root.second, 0});
  }
  std::erase_if(t.flutter, is_pair);
  std::stable_sort(t.modes.begin(), t.modes.end(), [](const auto& a, const auto& b) { return a.omega < b.omega; });
  return t;
}

// λ² that an error of one ε in an entry of K makes, at most: ε max |K_ij|/√(M_ii M_jj).
double open_square(const System& system) {
  const Vector unit = system.mass().diagonal().cwiseSqrt().cwiseInverse();
  return epsilon * (unit.asDiagonal() * system.stiffness() * unit.asDiagonal()).cwiseAbs().maxCoeff();
}

// A zero mode is zero to rounding of the entries: a true root below that is one.
Truth with_zeros_to_rounding(const System& system, const ModesResult& r, Truth t) {
  Index surplus = r.index_balance.zero - t.zero_pairs;
  const double open = std::sqrt(open_square(system));
  for (; surplus > 0; --surplus) {
    const bool mode = !t.modes.empty() && (t.divergence.empty() || t.modes.front().omega < t.divergence.front());
    if (mode && t.modes.front().omega <= open) {
      t.modes.erase(t.modes.begin());
    } else if (!mode && !t.divergence.empty() && t.divergence.front() <= open) {
      t.divergence.erase(t.divergence.begin());
    } else {
      break;
    }
    ++t.zero_pairs;
  }
  return t;
}

}  // namespace

Faults compare(const System& system, const ModesResult& r, const Truth& truth, std::vector<double>* tightness) {
  const Truth t = with_zeros_to_rounding(system, r, with_undecided_pairs(r, truth));
  Faults f;
  const bool decided = r.stability != Stability::unknown && r.stability != Stability::marginal;
  if (decided && r.stability != t.stability) {
    note(f, f.false_verdict,
         fmt::format("verdict {}, true {} (distance {:.2g})", to_string(r.stability), to_string(t.stability), t.distance));
  }
  if (r.stability == Stability::marginal && t.stability != Stability::marginal && t.distance > 1e-7) f.evaded = true;
  Index growing = 0;  // a quadruple that is two real pairs within its bound counts as much
  for (const UnstableMode& u : r.unstable) growing += u.flutter() ? 2 : 1;
  const Index truly = static_cast<Index>(t.divergence.size() + 2 * t.flutter.size());
  if (r.stability == Stability::unstable && r.index_balance.closed && growing != truly)
    note(f, f.false_verdict, fmt::format("{} growing roots, true {}", growing, truly));
  if (r.coverage.status == CoverageStatus::complete) compare_modes(r, t, f, tightness);
  compare_growth(r, t, f);
  if (!r.coverage.requested.open()) compare_window(r, t, f);
  if (r.coverage.status == CoverageStatus::complete && r.coverage.counted && *r.coverage.counted != true_modes_in(t, r.coverage.window)) {
    note(f, f.false_count, fmt::format("counted {}, true {}", *r.coverage.counted, true_modes_in(t, r.coverage.window)));
  }
  f.refused = r.coverage.status != CoverageStatus::complete || r.stability == Stability::unknown;
  return f;
}

}  // namespace gyromode::support
