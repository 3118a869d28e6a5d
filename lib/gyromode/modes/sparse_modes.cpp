#include "gyromode/modes/sparse_modes.h"

#include "gyromode/base/rounding.h"
#include "gyromode/modes/shape.h"
#include "gyromode/sparse/basis.h"

#include <algorithm>

namespace gyromode {

namespace {

constexpr double worst_residual = 1e-10;  // of a mode that is listed

}  // namespace

Index most_applied(Index wanted) {
  constexpr Index start = 1200, each = 30;
  return start + each * wanted;
}

Index converged_in(const std::vector<sparse::Search::Expected>& inside) {
  return std::count_if(inside.begin(), inside.end(), [](const auto& e) { return e.converged; });
}

std::optional<Window> wanted_if(bool enough, const Window& range) { return enough ? std::optional<Window>(range) : std::nullopt; }

sparse::MeasuredRoots listable(sparse::Search& search, const sparse::Goal& goal, const Progress& progress) {
  sparse::MeasuredRoots found = search_for(search, goal, progress);
  std::erase_if(found.modes, [](const auto& m) { return !(m.residual <= worst_residual); });
  return found;
}

sparse::Goal all_of(const Window& range, Index expected) {
  sparse::Goal goal;
  goal.range = range;
  goal.enough = [range, expected](const auto& inside) { return wanted_if(converged_in(inside) >= expected, range); };
  goal.missing = expected;
  goal.most_applied = most_applied(expected);
  return goal;
}

double gap_after(const SparseModes& roots, Index count) {
  for (std::size_t k = static_cast<std::size_t>(std::max<Index>(count, 1)); k < roots.size(); ++k) {
    const double from = roots[k - 1].omega + 4 * roots[k - 1].error_bound, to = roots[k].omega - 4 * roots[k].error_bound;
    if (to > from) return 0.5 * (from + to);
  }
  return 0;
}

double error_of(const sparse::RitzMode& m) { return std::max(m.error_bound, 4 * epsilon * m.omega); }

Mode mode_of(const SparseSystem& system, const sparse::RitzMode& m, bool with_shape) {
  Mode mode;
  mode.omega = m.omega;
  mode.energy_sign = m.energy_sign;
  mode.residual = m.residual;
  mode.error_bound = m.error_bound;
  if (system.basis()) mode.residual += system.basis()->departure;
  if (with_shape) {
    const ComplexVector shape = sparse::in_given(system, m.shape);
    mode.form = m.form / std::norm(largest_entry(shape));
    mode.shape = normalised(shape);
  }
  return mode;
}

}  // namespace gyromode
