#include "gyromode/dense/solve.h"

#include "gyromode/base/error.h"
#include "gyromode/dense/classical/classical.h"
#include "gyromode/dense/second_order.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode::dense {

namespace {

std::vector<Index> ordered(const Component& component, bool with_partition) {
  if (!with_partition) return component.coordinates;
  std::vector<Index> order = component.in_phase;
  order.insert(order.end(), component.in_quadrature.begin(), component.in_quadrature.end());
  return order;
}

bool hidden_applies(const Component& component, Method method) {
  return component.hidden_quadrature() && (method == Method::automatic || method == Method::hidden);
}

void require_reversing_symmetry(const Component& component, const Labels& labels) {
  if (component.quadrature() || component.hidden_quadrature()) return;
  const std::string& first = labels[static_cast<std::size_t>(component.coordinates.front())];
  const std::string why =
      component.search
          ? fmt::format("the nearest reflection breaks the commutation rules by {:.2g} of ‖K‖ and ‖G‖, where rounding explains {:.2g}",
                        component.search->departure, component.search->threshold)
          : "none was looked for";
  throw NotApplicable(fmt::format(
      "method 'hidden' needs a reversing symmetry, which the component of coordinate '{}' does not have: {}; 'auto' or 'general' apply",
      first, why));
}

void require_partition(const Component& component, const Labels& labels) {
  if (component.quadrature()) return;
  const Index first = component.odd_cycle->coordinates.front();
  throw NotApplicable(fmt::format(
      "method 'quadrature' needs a quadrature partition, which the component of coordinate '{}' does not have (gyromode structure shows "
      "why); 'auto' or 'general' apply",
      labels[static_cast<std::size_t>(first)]));
}

}  // namespace

Matrix restricted(const Matrix& a, const std::vector<Index>& rows, const std::vector<Index>& columns) {
  const auto consecutive = [](const std::vector<Index>& at) {
    return !at.empty() && at.back() - at.front() == static_cast<Index>(at.size()) - 1 && std::is_sorted(at.begin(), at.end());
  };
  if (!consecutive(rows)) return a(rows, columns);
  Matrix part(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) part.col(static_cast<Index>(k)) = a.col(columns[k]).segment(rows.front(), part.rows());
  return part;
}

namespace {

void fill(const Impedance& h, const Component& component, Method method, Spectrum& s) {
  if (h.quadrature()) {
    solve_second_order(SecondOrderQuadrature{h.mass_rr(), h.mass_ii(), h.gyroscopic_ri(), h.stiffness_rr(), h.stiffness_ii()}, s);
    return;
  }
  const SecondOrder matrices{h.mass_rr(), h.gyroscopic_ri(), h.stiffness_rr()};
  if (hidden_applies(component, method) && solve_second_order(matrices, component.search->found->in_units(h.units()), s)) return;
  switch (method) {
    case Method::companion: solve_companion(matrices, s); break;
    case Method::meirovitch: solve_symmetric_2n(matrices, s); break;
    default: solve_second_order(matrices, s); break;
  }
}

template <class AnySystem>
Spectrum in_given_units(const AnySystem& system, const Component& component, Method method) {
  const Impedance h = impedance_of(system, component, method);
  Spectrum s = solve(h, component, method);
  h.to_given(s);
  return s;
}

}  // namespace

Impedance impedance_of(const System& system, const Component& component, Method method) {
  if (method == Method::quadrature) require_partition(component, system.labels());
  if (method == Method::hidden) require_reversing_symmetry(component, system.labels());
  const bool with_partition =
      component.quadrature() && (method == Method::automatic || method == Method::quadrature || method == Method::hidden);
  return Impedance::natural(system, ordered(component, with_partition),
                            with_partition ? static_cast<Index>(component.in_phase.size()) : -1);
}

Impedance impedance_of(const FirstOrderSystem& system, const Component& component, Method method) {
  if (method == Method::quadrature) require_partition(component, system.labels());
  if (method == Method::hidden)
    throw NotApplicable(
        "method 'hidden' serves second-order models: every first-order model has a reversing symmetry, and 'general' makes use of it");
  if (method == Method::companion || method == Method::meirovitch) {
    throw NotApplicable(
        "the classical 2n methods start from M, G, K; a first-order model is solved as it stands: use 'auto', 'quadrature' or 'general'");
  }
  const bool with_partition = component.quadrature() && method != Method::general;
  return Impedance::natural(system, ordered(component, with_partition),
                            with_partition ? static_cast<Index>(component.in_phase.size()) : -1);
}

Spectrum solve(const Impedance& h, const Component& component, Method method) {
  Spectrum s;
  s.order = h.order();
  s.split = h.split();
  if (h.second_order()) {
    fill(h, component, method, s);
  } else {
    solve_first_order(h, s);
  }
  return s;
}

Spectrum solve(const System& system, const Component& component, Method method) { return in_given_units(system, component, method); }
Spectrum solve(const FirstOrderSystem& system, const Component& component, Method method) {
  return in_given_units(system, component, method);
}

}  // namespace gyromode::dense
