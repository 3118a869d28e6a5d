#include "gyromode/modes/components.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/refinement/correct.h"
#include "gyromode/refinement/polish.h"
#include "gyromode/structure/inertia_of_k.h"
#include "gyromode/refinement/undecided_flutter.h"
#include "gyromode/dense/refinement/own_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// Stages of small components are over before anybody could read of them.
constexpr Index worth_a_word = 100;

void go_on(const Progress& progress, Index size, std::string_view stage) {
  if (progress.stopped()) throw Interrupted();
  if (size >= worth_a_word) progress.stage(stage);
}

// Everything in the units of the impedance until the end.
SolvedComponent certified(dense::Impedance impedance, Spectrum spectrum, const Progress& progress) {
  const Index n = spectrum.size();
  go_on(progress, n, "residuals and error bounds");
  Assessment assessment = correct(impedance, spectrum);
  polish(impedance, spectrum, assessment);
  go_on(progress, n, "energy signs and verdict");
  if (impedance.second_order()) return_undecided_flutter(impedance, spectrum, assessment);
  Verdict verdict = verdict_on(impedance, spectrum, assessment);
  return {std::move(spectrum), std::move(impedance), std::move(assessment), std::move(verdict)};
}

template <class AnySystem>
SolvedComponent solved_component(const AnySystem& system, const Component& component, Method method, const Progress& progress) {
  const auto n = static_cast<Index>(component.coordinates.size());
  go_on(progress, n, "choice of units");
  dense::Impedance impedance = dense::impedance_of(system, component, method);
  go_on(progress, n, "roots and shapes");
  Spectrum spectrum = dense::solve(impedance, component, method);
  return certified(std::move(impedance), std::move(spectrum), progress);
}

double worst_residual(const SolvedComponent& c) {
  double worst = 0;
  for (const Vector* residuals : {&c.assessment.own_residual, &c.assessment.unstable.own_residual}) {
    for (const double r : *residuals) worst = r <= worst ? worst : std::isfinite(r) ? r : infinity;
  }
  return worst;
}

void to_given_units(SolvedComponent& c) {
  const Units& units = c.impedance.units();
  // Of the shapes as they stand, no more of shapes of norm 1.
  for (Index k = 0; k < c.spectrum.omega.size(); ++k)
    c.assessment.form(k) *= (c.spectrum.re.col(k).squaredNorm() + c.spectrum.im.col(k).squaredNorm()) / units.time;
  c.impedance.to_given(c.spectrum);
  for (Vector* v :
       {&c.assessment.error_bound, &c.assessment.sensitivity, &c.assessment.unstable.error_bound, &c.assessment.unstable.sensitivity})
    *v /= units.time;
}

// What a certificate will ask for: the index balance closed and residuals at rounding.
bool convincing(const SolvedComponent& c) {
  const double limit = solver_residual(c.spectrum.size());
  return c.verdict.balance.closed && worst_residual(c) <= limit;
}

// Better evidence: the balance closed, then the smaller worst residual.
bool better(const SolvedComponent& a, const SolvedComponent& b) {
  return a.verdict.balance.closed && (!b.verdict.balance.closed || worst_residual(a) < worst_residual(b));
}

// A further attempt; nothing where work was stopped meanwhile: what is there stands.
template <class Attempt>
std::optional<SolvedComponent> further(Attempt&& attempt) {
  try {
    return attempt();
  } catch (const Interrupted&) {
    return std::nullopt;
  }
}

// A solver of one scale loses roots far below the largest where spin is strong or K graded and indefinite. Where the
// result does not convince, the general solver has a try (λ of the first-order form keeps roots that ω² loses), and
// then, in a small system, every root is found in its own scale.
template <class AnySystem>
SolvedComponent best_component(const AnySystem& system, const Component& component, Method method, const Progress& progress) {
  SolvedComponent best = solved_component(system, component, method, progress);
  if (method != Method::automatic || convincing(best) || !best.impedance.second_order()) return best;
  constexpr Index own_scale_up_to = 48;
  if (best.impedance.size() <= own_scale_up_to) {
    dense::Impedance h = best.impedance.with_null_coordinates().value_or(best.impedance);
    Spectrum known = best.spectrum;
    best.impedance.to_given(known);
    known.zero_shapes = h.own_shapes(known.zero_shapes);
    if (auto roots = dense::solve_in_own_scale(h, known)) {
      auto again = further([&] { return certified(std::move(h), std::move(*roots), progress); });
      if (again && better(*again, best)) best = std::move(*again);
    }
  }
  const bool by_partition = component.quadrature() || component.hidden_quadrature();
  if (convincing(best) || (best.spectrum.stiffness_negative == 0 && component.quadrature()) || !by_partition) return best;
  auto again = further([&] { return solved_component(system, component, Method::general, progress); });
  if (!again || !better(*again, best)) return best;
  again->spectrum.solver += " (quadrature solver did not convince)";
  return std::move(*again);
}

// A reversing symmetry is of use to two methods only.
HiddenSearch search_for(Method method) {
  if (method == Method::hidden) return HiddenSearch::always;
  return method == Method::automatic ? HiddenSearch::by_cost : HiddenSearch::never;
}

Structure structure_for(const System& system, Method method) { return analyse(system, search_for(method)); }
Structure structure_for(const FirstOrderSystem& system, Method) { return analyse(system); }

std::optional<InertiaOfK> inertia_of_whole(const System& system) { return inertia_of_k(system.stiffness()); }
std::optional<InertiaOfK> inertia_of_whole(const FirstOrderSystem&) { return std::nullopt; }

template <class AnySystem>
SolvedSystem solved(const AnySystem& system, Method method, const Progress& progress) {
  SolvedSystem s;
  s.size = system.size();
  go_on(progress, s.size, "structure");
  s.structure = structure_for(system, method);
  const Index all = static_cast<Index>(s.structure.components.size());
  for (const Component& component : s.structure.components) {
    try {
      s.components.push_back(best_component(system, component, method, progress));
    } catch (const Interrupted&) {
      if (s.components.empty()) throw;
      s.interrupted = true;
      s.whole = inertia_of_whole(system);
      break;
    }
    to_given_units(s.components.back());
    if (all > 1) progress.report("components", static_cast<Index>(s.components.size()), all);
  }
  return s;
}

struct SignedRoot {
  double omega, movement;
  int sign;
};

// Over all components: neighbours of opposite sign that a backward error of n ε makes coincide.
bool opposite_roots_coincide(const SolvedSystem& s) {
  std::vector<SignedRoot> roots;
  const double eta = backward_error(s.size);
  for (const SolvedComponent& c : s.components) {
    for (Index i = 0; i < c.spectrum.omega.size(); ++i) {
      roots.push_back({c.spectrum.omega(i), eta * c.assessment.sensitivity(i), c.verdict.energy_sign[static_cast<std::size_t>(i)]});
    }
  }
  std::sort(roots.begin(), roots.end(), [](const SignedRoot& a, const SignedRoot& b) { return a.omega < b.omega; });
  for (std::size_t i = 0; i + 1 < roots.size(); ++i) {
    for (std::size_t k = i + 1; k < roots.size(); ++k) {
      if (roots[k].omega - roots[i].omega > roots[i].movement + roots[k].movement) break;
      if (roots[i].sign * roots[k].sign < 0) return true;
    }
  }
  return false;
}

}  // namespace

SolvedSystem solve_components(const System& system, Method method, const Progress& progress) { return solved(system, method, progress); }

SolvedSystem solve_components(const FirstOrderSystem& system, Method method, const Progress& progress) {
  SolvedSystem s = solved(system, method, progress);
  s.first_order = true;
  return s;
}

Stability SolvedSystem::stability() const {
  Stability worst = interrupted ? Stability::unknown : Stability::stable;
  for (const SolvedComponent& c : components) worst = std::max(worst, c.verdict.stability);
  if (worst < Stability::marginal && opposite_roots_coincide(*this)) return Stability::marginal;
  return worst;
}

IndexBalance SolvedSystem::index_balance() const {
  IndexBalance sum;
  for (const SolvedComponent& c : components) sum += c.verdict.balance;
  sum.closed = sum.closed && !interrupted;
  if (whole) sum.negative = whole->negative;
  return sum;
}

std::string SolvedSystem::open_reason() const {
  if (interrupted) return fmt::format("interrupted: {} of {} components were solved", components.size(), structure.components.size());
  for (const SolvedComponent& c : components) {
    if (!c.verdict.balance.closed) return c.verdict.reason;
  }
  return "";
}

InertiaOfK SolvedSystem::stiffness() const {
  if (whole) return *whole;
  InertiaOfK k;
  for (const SolvedComponent& c : components) {
    k.negative += c.spectrum.stiffness_negative;
    k.zero += c.spectrum.stiffness_zero;
  }
  return k;
}

std::string SolvedSystem::solver() const {
  // Components of one path are named together: "… (3 components of up to 4 coordinates)".
  std::vector<std::string> order;
  std::vector<std::pair<Index, Index>> tally;  // how many, the largest
  for (const SolvedComponent& c : components) {
    const auto at = std::find(order.begin(), order.end(), c.spectrum.solver);
    const std::size_t k = static_cast<std::size_t>(at - order.begin());
    if (at == order.end()) {
      order.push_back(c.spectrum.solver);
      tally.emplace_back(0, 0);
    }
    ++tally[k].first;
    tally[k].second = std::max(tally[k].second, c.spectrum.size());
  }
  if (components.size() == 1) return order.front();
  std::string line;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto [count, largest] = tally[k];
    line += fmt::format("{}{} ({} component{} of {}{} coordinate{})", k == 0 ? "" : "; ", order[k], count, count == 1 ? "" : "s",
                        count == 1 ? "" : "up to ", largest, largest == 1 ? "" : "s");
  }
  return line;
}

Inertia SolvedSystem::inertia_at(double omega) const {
  Inertia sum;
  for (const SolvedComponent& c : components) {
    const Inertia part = c.impedance.inertia_at(omega * c.impedance.units().time);
    sum.negative += part.negative;
    sum.positive += part.positive;
    sum.margin = std::min(sum.margin, part.doubtful() ? 0 : part.margin);
  }
  return sum;
}

Index SolvedSystem::negative_at_zero() const {
  Index sum = 0;
  for (const SolvedComponent& c : components) {
    sum += first_order ? c.impedance.half_rank_of_gyroscopic() : c.spectrum.impedance_negative;
  }
  return sum;
}

}  // namespace gyromode
