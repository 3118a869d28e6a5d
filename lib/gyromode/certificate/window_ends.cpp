#include "gyromode/certificate/window_ends.h"

#include "gyromode/base/rounding.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

struct End {
  double omega = 0;
  Inertia inertia;
};

class Ends {
 public:
  explicit Ends(const CountedSpectrum& s) : s_(s), all_(s.all_roots()) {}

  // `outward` is 1 for the upper end, −1 for the lower.
  End end(double omega, double outward) const {
    const End asked{omega, s_.inertia_at(omega)};
    if (serves(asked)) return asked;
    if (const auto elsewhere = in_gap(omega)) return {omega, *elsewhere};
    constexpr double farthest = 1e-3;
    for (double step = 16 * epsilon; step <= farthest; step *= s_.outward()) {
      const double moved = omega * (1 + outward * step);
      const End end{moved, s_.inertia_at(moved)};
      if (serves(end)) return end;
    }
    return asked;
  }

 private:
  // Not doubtful, and what the roots found below ω make of n₋(H(0⁺)).
  bool serves(const End& end) const { return !end.inertia.doubtful() && (!all_ || end.inertia.negative == expected(end.omega)); }

  Index expected(double omega) const {
    Index n = s_.negative_at_zero();
    for (const CountedRoot& r : *all_) {
      if (!r.zero && r.omega < omega) n += Index{s_.direction()} * r.energy_sign;
    }
    return n;
  }

  std::optional<Inertia> in_gap(double omega) const {
    constexpr double near = 1e-2;
    if (!all_) return std::nullopt;
    double below = 0, above = 2 * s_.above_all();
    for (const CountedRoot& r : *all_) {
      if (r.omega > 0 && std::abs(r.omega - omega) <= near * omega) return std::nullopt;
      if (r.omega < omega)
        below = std::max(below, r.omega);
      else
        above = std::min(above, r.omega);
    }
    for (const double part : {0.5, 0.25, 0.75, 0.1}) {
      const Inertia at = s_.inertia_at(below + part * (above - below));
      if (at.doubtful()) continue;
      if (at.negative != expected(omega)) break;
      return at;
    }
    return std::nullopt;
  }

  const CountedSpectrum& s_;
  const std::vector<CountedRoot>* all_;
};

}  // namespace

WindowEnds ends_of(const CountedSpectrum& s, const Window& requested) {
  const Ends ends(s);
  WindowEnds w{requested, {s.negative_at_zero(), 0, 1}, {}};
  if (requested.a > 0) {
    const End low = ends.end(requested.a, -1);
    w.window.a = low.omega;
    w.low = low.inertia;
  }
  if (requested.open()) {
    w.high = s.inertia_at(std::max(s.above_all(), 2 * requested.a));
  } else {
    const End high = ends.end(requested.b, 1);
    w.window.b = high.omega;
    w.high = high.inertia;
  }
  return w;
}

}  // namespace gyromode
