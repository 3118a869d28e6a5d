#include "gyromode/modes/sparse_counts.h"

#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/inverse_iteration.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

Inertia SparseCounts::at(double omega) const {
  Inertia i;
  if (known_.b > 0 && omega >= known_.a && omega <= known_.b) {  // between roots that are all there are
    i.margin = 1;
    i.negative = known_negative_;
    for (const sparse::RitzMode& m : in_known_) {
      if (std::abs(m.omega - omega) <= error_of(m)) i.margin = 0;
      if (m.omega < omega) i.negative += m.energy_sign;
    }
    i.positive = system_.size() - i.negative;
    return i;
  }
  const auto known = counted_.find(omega);
  if (known != counted_.end()) return known->second.inertia;
  searches_.release_zero();  // it makes room
  const auto h = searches_.impedance(omega);
  i.negative = searches_.negative_at(omega);
  i.positive = system_.size() - i.negative;
  const double rounding = system_.basis() ? 10 * system_.basis()->departure : 0;
  i.margin = h->margin > std::max(sparse::singular_margin, rounding) ? 1 : 0;
  return counted_.emplace(omega, Counted{i, h->margin}).first->second.inertia;
}

double SparseCounts::margin(double omega) const {
  const auto known = counted_.find(omega);
  return known != counted_.end() ? known->second.margin : searches_.impedance(omega)->margin;
}

Index SparseCounts::between(double a, double b) const {
  const Index low = a > 0 ? at(a).negative : at_zero();
  return at(b).negative - low + balance_.missed_by_signs({a, b});
}

double SparseCounts::middle_of(double a, double b) const {
  constexpr int attempts = 8;
  double middle = 0.5 * (a + b);
  for (int k = 0; k < attempts && at(middle).doubtful(); ++k) middle += 0.013 * (b - a);
  return middle;
}

double SparseCounts::clear_of_roots(double omega) const {
  constexpr int attempts = 8;
  constexpr double step = 1e-5;
  double w = omega * (1 + step);
  for (int k = 1; k < attempts && at(w).doubtful(); ++k) w = omega * (1 + step * std::exp2(k));
  return w;
}

void SparseCounts::know(const Window& window, Index negative, const SparseModes& modes) {
  known_ = window;
  known_negative_ = negative;
  in_known_.clear();
  for (const sparse::RitzMode& m : modes) {
    if (window.contains(m.omega)) in_known_.push_back({m.omega, m.energy_sign, m.form, m.residual, m.error_bound, {}});
  }
}

}  // namespace gyromode
