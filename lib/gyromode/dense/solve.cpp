#include "gyromode/dense/solve.h"

#include "gyromode/dense/classical.h"
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
  const std::string first = labels[static_cast<std::size_t>(component.coordinates.front())];
  const std::string why = component.search ? fmt::format("the nearest reflection breaks the commutation rules by {:.2g} of ‖K‖ and ‖G‖, where rounding explains {:.2g}", component.search->breach,
                                                         component.search->threshold)
                                           : "none was looked for";
  throw MethodDoesNotApply(fmt::format("method 'hidden' needs a reversing symmetry, which the component of coordinate '{}' does not have: {}; 'auto' or 'general' apply", first, why));
}

void require_partition(const Component& component, const Labels& labels) {
  if (component.quadrature()) return;
  const Index first = component.odd_cycle->coordinates.front();
  throw MethodDoesNotApply(
      fmt::format("method 'quadrature' needs a quadrature partition, which the component of coordinate '{}' does not have (gyromode structure shows "
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

void Spectrum::store_stiffness(const Definiteness& d) {
  stiffness_negative = reduced_negative = impedance_negative = d.negative;
  stiffness_zero = d.zero;
  stiffness_margin = d.margin;
  zero_shapes.resize(size(), 0);
}

ComplexVector Spectrum::shape(Index k) const {
  ComplexVector x = ComplexVector::Zero(size());
  if (split < 0) {
    x.real() = re.col(k);
    x.imag() = im.col(k);
  } else {
    x.head(split).real() = re.col(k);
    x.tail(size() - split).imag() = im.col(k);
  }
  return x;
}

Spectrum solve(const System& system, const Component& component, Method method) {
  if (method == Method::quadrature) require_partition(component, system.labels());
  if (method == Method::hidden) require_reversing_symmetry(component, system.labels());
  const bool with_partition = component.quadrature() && (method == Method::automatic || method == Method::quadrature || method == Method::hidden);
  Spectrum s;
  s.order = ordered(component, with_partition);
  s.split = with_partition ? static_cast<Index>(component.in_phase.size()) : -1;
  if (with_partition) {
    const auto& first = component.in_phase;
    const auto& second = component.in_quadrature;
    solve_second_order(SecondOrderQuadrature{restricted(system.mass(), first, first), restricted(system.mass(), second, second),
                                             restricted(system.gyroscopic(), first, second), restricted(system.stiffness(), first, first),
                                             restricted(system.stiffness(), second, second)},
                       s);
    return s;
  }
  const SecondOrder matrices{restricted(system.mass(), s.order, s.order), restricted(system.gyroscopic(), s.order, s.order),
                             restricted(system.stiffness(), s.order, s.order)};
  if (hidden_applies(component, method) && solve_second_order(matrices, *component.search->found, s)) return s;
  switch (method) {
    case Method::first_order: solve_companion(matrices, s); break;
    case Method::symmetric_2n: solve_symmetric_2n(matrices, s); break;
    default: solve_second_order(matrices, s); break;
  }
  return s;
}

Spectrum solve(const FirstOrderSystem& system, const Component& component, Method method) {
  if (method == Method::quadrature) require_partition(component, system.labels());
  if (method == Method::hidden) throw MethodDoesNotApply("method 'hidden' serves second-order models: every first-order model has a reversing symmetry, and 'general' makes use of it");
  if (method == Method::first_order || method == Method::symmetric_2n) {
    throw MethodDoesNotApply("the classical 2n methods start from M, G, K; a first-order model is solved as it stands: use 'auto', 'quadrature' or 'general'");
  }
  const bool with_partition = component.quadrature() && method != Method::general;
  Spectrum s;
  s.order = ordered(component, with_partition);
  s.split = with_partition ? static_cast<Index>(component.in_phase.size()) : -1;
  solve_first_order(restricted(system.inertia(), s.order, s.order), restricted(system.gyroscopic(), s.order, s.order), s);
  return s;
}

}  // namespace gyromode::dense
