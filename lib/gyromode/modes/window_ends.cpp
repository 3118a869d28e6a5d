#include "gyromode/modes/window_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct End {
  double omega = 0;
  Inertia inertia;
};

class Ends {
 public:
  Ends(const SolvedSystem& s, const Frequencies& f) : s_(s), f_(f), at_zero_(s.negative_at_zero()) {}

  Inertia at_zero() const { return {at_zero_, 0, 1}; }

  // n₋ that the modes found below ω make of n₋(H(0⁺)).
  Index expected(double omega) const {
    Index n = at_zero_;
    for (const auto& e : f_.entries) {
      if (e.position >= 0 && e.omega < omega) n += (s_.first_order ? -1 : 1) * e.energy_sign;
    }
    return n;
  }

  bool serves(const End& end) const { return !end.inertia.doubtful() && end.inertia.negative == expected(end.omega); }

  // `outward` is 1 for the upper end, −1 for the lower.
  End end(double omega, double outward) const {
    const End asked{omega, s_.negative_at(omega)};
    if (serves(asked)) return asked;
    if (!mode_near(omega)) {
      if (const auto elsewhere = in_gap(omega); !elsewhere.doubtful() && elsewhere.negative == expected(omega)) return {omega, elsewhere};
    }
    constexpr double farthest = 1e-3;
    for (double step = 16 * epsilon; step <= farthest; step *= 4) {
      const double moved = omega * (1 + outward * step);
      const End end{moved, s_.negative_at(moved)};
      if (serves(end)) return end;
    }
    return asked;
  }

  double above_all() const {
    if (!f_.entries.empty() && f_.entries.back().omega > 0) return 1.125 * f_.entries.back().omega;
    double typical = 0;  // where no mode was found any frequency that has the unit of the system
    for (const SolvedComponent& c : s_.components) typical = std::max(typical, c.impedance.typical_frequency());
    return typical > 0 ? typical : 1;  // M alone: every ω is as good
  }

 private:
  bool mode_near(double omega) const {
    constexpr double near = 1e-2;
    return std::any_of(f_.entries.begin(), f_.entries.end(), [&](const auto& e) { return e.omega > 0 && std::abs(e.omega - omega) <= near * omega; });
  }

  Inertia in_gap(double omega) const {
    double below = 0, above = 2 * above_all();
    for (const auto& e : f_.entries) {
      if (e.omega < omega) below = std::max(below, e.omega);
      else above = std::min(above, e.omega);
    }
    Inertia at{0, 0, 0};
    for (const double part : {0.5, 0.25, 0.75, 0.1}) {
      at = s_.negative_at(below + part * (above - below));
      if (!at.doubtful()) break;
    }
    return at;
  }

  const SolvedSystem& s_;
  const Frequencies& f_;
  Index at_zero_;
};

}  // namespace

WindowEnds ends_of(const SolvedSystem& s, const Frequencies& f, const Window& requested) {
  const Ends ends(s, f);
  WindowEnds w{requested, ends.at_zero(), {}};
  if (requested.a > 0) {
    const End low = ends.end(requested.a, -1);
    w.window.a = low.omega;
    w.low = low.inertia;
  }
  if (requested.open()) {
    w.high = s.negative_at(ends.above_all());
  } else {
    const End high = ends.end(requested.b, 1);
    w.window.b = high.omega;
    w.high = high.inertia;
  }
  return w;
}

}  // namespace gyromode
