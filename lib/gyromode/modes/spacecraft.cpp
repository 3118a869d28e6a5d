#include "gyromode/modes/spacecraft.h"

#include "gyromode/modes/spacecraft_shapes.h"
#include "gyromode/modes/spacecraft_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace gyromode {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Mode zero_mode(Index label, bool with_shape) {
  Mode m;
  m.energy_sign = 0;
  m.kind = ModeKind::rigid_body;
  if (with_shape) {
    m.shape = ComplexVector::Zero(6);
    if (label >= 0) m.shape(label) = 1;
  }
  return m;
}

Mode mode_of(const SpacecraftSolution& s, const Root& r, bool with_shape) {
  const bool tilt = SpacecraftSolution::is_tilt(r);
  Mode m;
  m.omega = tilt ? s.unit() : r.omega * s.unit();
  m.energy_sign = r.energy_sign;
  m.residual = std::abs(r.value / (r.omega * r.slope));
  m.error_bound = tilt ? 0 : r.error * s.unit();
  m.bracket = std::array{std::min(r.lo, r.omega) * s.unit(), std::max(r.hi, r.omega) * s.unit()};
  m.kind = tilt ? ModeKind::rigid_body : body_at_rest(r) ? ModeKind::local : ModeKind::vibration;
  if (with_shape) add_shape(s, r, m);
  return m;
}

void require_within_reach(const Spacecraft& s, const Window& w) {
  constexpr double farthest = farthest_over_spin;
  const double highest = w.open() ? w.a : w.b;
  if (s.cables().empty() || !(highest > farthest * s.spin())) return;
  throw std::invalid_argument(fmt::format("{:.6g} rad/s is beyond reach: fields of wires are followed up to {:.0e} times the spin, {:.6g} rad/s", highest, farthest, farthest * s.spin()));
}

}  // namespace

Structure analyse(const Spacecraft& spacecraft) {
  const SpacecraftImpedance impedance(spacecraft);
  return structure_of(BlockedImpedance(impedance));
}

ModesResult find_modes(const Spacecraft& spacecraft, const ModesOptions& options) {
  require_window(options.window);
  if (options.method != dense::Method::automatic) {
    throw dense::MethodDoesNotApply("the methods 'quadrature', 'hidden', 'general', 'first-order' and 'symmetric-2n' serve matrices; a spacecraft takes 'exact' or 'discrete'");
  }
  require_within_reach(spacecraft, options.window);
  const SpacecraftSolution s(spacecraft);
  if (options.window.open() && !options.lowest && s.impedance().continuous()) {
    throw std::invalid_argument("a spacecraft with exact booms has infinitely many modes: a window with two ends or the number of lowest ones is needed");
  }
  const double unit = s.unit();
  Window window{options.window.a / unit, options.window.b / unit};
  if (window.open() && !s.impedance().continuous()) window.b = std::max(s.above_all(), 2 * window.a);
  if (options.lowest) window = lowest_window(s, *options.lowest, window);
  window = s.cleared(window);
  const std::vector<Root> around = s.roots_around(window.a, window.b);
  std::vector<Root> inside;
  std::copy_if(around.begin(), around.end(), std::back_inserter(inside), [&](const Root& r) { return window.contains(r.omega); });

  ModesResult r;
  r.transcendental = true;
  r.structure = structure_of(s.roots().blocked());
  r.path = s.path();
  r.stability = s.stability();
  r.index_balance = s.balance();
  r.stiffness = {r.index_balance.negative > 0 ? Sign::indefinite : Sign::semidefinite, r.index_balance.negative, r.index_balance.zero};
  r.coverage = coverage_of(s, options.window, window, inside);
  r.coverage.window = in_units(window, unit, options.window);
  if (options.window.open() && !options.lowest) r.coverage.window.b = infinity;  // all of them
  if (options.shapes) r.outlines = outlines_of(s);
  if (window.a == 0) {
    r.modes.push_back(zero_mode(2, options.shapes));
    r.modes.push_back(zero_mode(5, options.shapes));
    for (Index k = 2; k < s.zeros(); ++k) r.modes.push_back(zero_mode(-1, options.shapes));
  }
  for (const Root& root : inside) r.modes.push_back(mode_of(s, root, options.shapes));
  for (const Root& root : s.roots().negative_energy()) r.negative_modes.push_back(mode_of(s, root, false));
  for (const GrowingRoot& g : s.roots().growing()) {
    for (Index k = 0; k < g.copies; ++k) r.unstable.push_back({g.growth * unit, g.omega * unit, g.residual, g.error * unit, {}});
  }
  std::sort(r.unstable.begin(), r.unstable.end(), [](const UnstableMode& a, const UnstableMode& b) { return a.growth_rate > b.growth_rate; });
  r.opposite_gap = s.opposite_gap();
  return r;
}

CountResult count_modes(const Spacecraft& spacecraft, const Window& requested) {
  require_window(requested);
  require_within_reach(spacecraft, requested);
  const SpacecraftSolution s(spacecraft);
  if (requested.open() && s.impedance().continuous()) throw std::invalid_argument("a spacecraft with exact booms has infinitely many modes: a window with two ends is needed");
  const double unit = s.unit();
  Window window{requested.a / unit, requested.b / unit};
  if (window.open()) window.b = std::max(s.above_all(), 2 * window.a);
  const Window used = s.cleared(window);
  CountResult c;
  c.requested = requested;
  c.window = in_units(used, unit, requested);
  if (requested.open()) c.window.b = infinity;
  const auto& blocked = s.roots().blocked();
  const auto negative = [&](double omega) {
    const Lifted lifted = blocked.impedance.at(omega);
    Index n = 0;
    for (std::size_t b = 0; b < blocked.blocks.size(); ++b) {
      n += (omega == 0 ? s.roots().at_zero().count[b] : state_of(blocked.blocks[b], lifted).count) * blocked.blocks[b].copies();
    }
    return n;
  };
  c.negative = {negative(used.a), negative(used.b)};
  c.signed_count = c.negative[1] - c.negative[0];
  c.zero = used.a == 0 ? s.zeros() : 0;
  const bool doubtful = s.roots().doubtful_at(used.b) || (used.a > 0 && s.roots().doubtful_at(used.a));
  c.status = doubtful ? CountStatus::doubtful : s.roots().closed() ? CountStatus::exact : CountStatus::signed_only;
  if (c.status == CountStatus::exact) c.count = s.roots().count(used.a, used.b) + c.zero;
  return c;
}

ComplexMatrix impedance_at(const Spacecraft& spacecraft, double omega) {
  require_within_reach(spacecraft, {0, omega});
  return SpacecraftImpedance(spacecraft).hub(omega);
}

}  // namespace gyromode
