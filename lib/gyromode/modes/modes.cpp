#include "gyromode/modes/modes.h"

#include "gyromode/modes/components.h"
#include "gyromode/modes/shape.h"
#include "gyromode/modes/window_ends.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gyromode {

namespace {

ComplexVector full_shape(const SolvedSystem& s, const dense::Spectrum& spectrum, const ComplexVector& part) {
  ComplexVector x = ComplexVector::Zero(s.size);
  for (Index i = 0; i < spectrum.size(); ++i) x(spectrum.order[static_cast<std::size_t>(i)]) = part(i);
  return normalised(std::move(x));
}

Mode made(const SolvedSystem& s, const Frequencies::Entry& e, bool with_shape) {
  const SolvedComponent& c = s.components[static_cast<std::size_t>(e.component)];
  Mode m;
  if (e.position < 0) {
    const bool rigid = s.first_order || c.spectrum.stiffness_negative == 0;
    m.kind = rigid ? ModeKind::rigid_body : ModeKind::vibration;
    m.energy_sign = 0;
    if (with_shape) m.shape = full_shape(s, c.spectrum, c.spectrum.zero_shapes.col(-1 - e.position).cast<Complex>());
    return m;
  }
  m.omega = e.omega;
  m.energy_sign = e.energy_sign;
  m.residual = c.assessment.residual(e.position);
  m.error_bound = c.assessment.error_bound(e.position);
  m.cluster = c.assessment.cluster[static_cast<std::size_t>(e.position)];
  if (with_shape) m.shape = full_shape(s, c.spectrum, c.spectrum.shape(e.position));
  return m;
}

UnstableMode grown(const SolvedSystem& s, const SolvedComponent& c, Index k, bool with_shape) {
  const Complex lambda = c.spectrum.unstable.lambda[static_cast<std::size_t>(k)];
  UnstableMode u{lambda.real(), lambda.imag(), c.assessment.unstable.residual(k), c.assessment.unstable.error_bound(k), {}};
  if (with_shape) u.shape = full_shape(s, c.spectrum, c.spectrum.unstable.right.col(k));
  return u;
}

bool rigid(const SolvedSystem& s, const Frequencies::Entry& e) {
  return e.position < 0 && (s.first_order || s.components[static_cast<std::size_t>(e.component)].spectrum.stiffness_negative == 0);
}

// [0, b) with b above the `lowest`-th mode that is no rigid-body one, in the middle of the gap that follows; modes that coincide with it come along.
Window lowest_window(const SolvedSystem& s, const Frequencies& f, Index lowest, const Window& requested) {
  Index seen = 0;
  for (std::size_t i = 0; i < f.entries.size(); ++i) {
    const auto& e = f.entries[i];
    if (e.omega < requested.a) continue;
    if (!rigid(s, e)) ++seen;
    if (seen < lowest || i + 1 == f.entries.size()) continue;
    const auto& next = f.entries[i + 1];
    const double from = e.omega + 4 * e.error;
    const double to = next.omega - 4 * next.error;
    if (to > from) return {requested.a, std::min(0.5 * (from + to), requested.b)};
  }
  return requested;
}

void require_options(const ModesOptions& options) {
  require_window(options.window);
  if (options.lowest && *options.lowest < 1) throw std::invalid_argument("lowest: at least 1 mode must be asked for");
}

ModesResult result_of(const SolvedSystem& s, const ModesOptions& options) {
  const Frequencies f(s);
  ModesResult r;
  r.structure = s.structure;
  r.stiffness = s.stiffness();
  r.path = s.path();
  r.first_order = s.first_order;
  r.stability = s.stability();
  r.index_balance = s.index_balance();
  const WindowEnds ends = ends_of(s, f, options.lowest ? lowest_window(s, f, *options.lowest, options.window) : options.window);
  const Window& window = ends.window;
  r.coverage = coverage(s, f, options.window, ends);
  r.opposite_gap = std::numeric_limits<double>::infinity();
  for (const SolvedComponent& c : s.components) {
    for (Index k = 0; k < c.spectrum.unstable.count(); ++k) {
      if (c.verdict.unstable_shown[static_cast<std::size_t>(k)]) r.unstable.push_back(grown(s, c, k, options.shapes));
    }
    r.opposite_gap = std::min(r.opposite_gap, c.verdict.gap);
  }
  std::sort(r.unstable.begin(), r.unstable.end(), [](const UnstableMode& a, const UnstableMode& b) { return a.growth_rate > b.growth_rate; });
  for (const auto& e : f.entries) {
    if (window.contains(e.omega)) r.modes.push_back(made(s, e, options.shapes));
    if (e.energy_sign < 0 || (e.energy_sign == 0 && e.position >= 0)) r.negative_modes.push_back(made(s, e, options.shapes));
  }
  return r;
}

}  // namespace

std::string_view word(ModeKind kind) {
  switch (kind) {
    case ModeKind::rigid_body: return "rigid_body";
    case ModeKind::local: return "local";
    default: return "vibration";
  }
}

std::string_view word(CoverageStatus status) {
  switch (status) {
    case CoverageStatus::complete: return "complete";
    case CoverageStatus::incomplete: return "incomplete";
    default: return "not_counted";
  }
}

ModesResult find_modes(const System& system, const ModesOptions& options) {
  require_options(options);
  return result_of(solve_components(system, options.method), options);
}

ModesResult find_modes(const FirstOrderSystem& system, const ModesOptions& options) {
  require_options(options);
  return result_of(solve_components(system, options.method), options);
}

}  // namespace gyromode
