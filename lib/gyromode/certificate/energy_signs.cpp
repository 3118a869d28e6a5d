#include "gyromode/certificate/energy_signs.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gyromode {

namespace {

// How far a backward error of η moves root i, capped where the root is so nearly defective that first order says
// nothing.
double movement(const Spectrum& s, const Assessment& a, Index i) {
  return std::min(backward_error(s.size()) * a.sensitivity(i), 1e-5 * s.omega(i));
}

// The last of the roots that a backward error can make coincide, one after the other, from `first` on.
Index end_of_cluster(const Spectrum& s, const Assessment& a, Index first) {
  Index last = first;
  while (last + 1 < s.omega.size() && s.omega(last + 1) - s.omega(last) <= movement(s, a, last) + movement(s, a, last + 1)) ++last;
  return last;
}

// A root has the sign of its form where a backward error moves it by a small part of its distance to every other root:
// then its form is far from zero.
bool sure(const Spectrum& s, const Assessment& a, Index i) {
  constexpr double small_part = 1e-3;
  const double omega = s.omega(i);
  double distance = omega;
  if (i > 0) distance = std::min(distance, omega - s.omega(i - 1));
  if (i + 1 < s.omega.size()) distance = std::min(distance, s.omega(i + 1) - omega);
  for (const Complex& z : s.unstable.lambda) distance = std::min(distance, std::abs(z - Complex(0, omega)));
  return backward_error(s.size()) * a.sensitivity(i) <= small_part * distance;
}

// The same for the roots of a cluster, of which only the form on their span counts.
bool sure_together(const Spectrum& s, const Assessment& a, Index i) {
  return backward_error(s.size()) * a.sensitivity(i) <= 1e-7 * s.omega(i);
}

// Positive minus negative eigenvalues of the form X_cᴴ(2ωM − jG)X_c on the unit shapes of a cluster: its signs, by
// Sylvester's law, if the shapes are independent and the form regular, both far from doubt.
std::optional<Index> signature(const Impedance& h, const Spectrum& s, Index first, Index last) {
  constexpr double regular = 1e-5;
  const Index count = last - first + 1;
  ComplexMatrix x(s.size(), count);
  for (Index i = 0; i < count; ++i) x.col(i) = s.shape(first + i).normalized();
  const auto weakest = [](const Vector& v) { return v.cwiseAbs().minCoeff() / v.cwiseAbs().maxCoeff(); };
  const Vector lengths = small::hermitian_eigenvalues(x.adjoint() * x);
  const ComplexMatrix form = h.form(x, 0.5 * (s.omega(first) + s.omega(last)));
  const Vector values = small::hermitian_eigenvalues(form);
  if (!(weakest(lengths) > regular) || !(weakest(values) > regular)) return std::nullopt;
  return (values.array() > 0).count() - (values.array() < 0).count();
}

// Positive minus negative roots in a cluster: the change of n₋(H) across it, counted as near to it as the
// factorisations are sure, and no farther than half way to the roots beside it. In a large system, where a
// factorisation costs, at the widest of these distances only.
std::optional<Index> jump(const Impedance& h, const Spectrum& s, const Assessment& a, Index first, Index last) {
  const double before = first > 0 ? s.omega(first - 1) + movement(s, a, first - 1) : 0;
  const double after = last + 1 < s.omega.size() ? s.omega(last + 1) - movement(s, a, last + 1) : 2 * s.omega(last);
  if (!(before < s.omega(first)) || !(after > s.omega(last))) return std::nullopt;
  const double lowest = 0.5 * (before + s.omega(first)), highest = 0.5 * (after + s.omega(last));
  const bool small = s.size() <= 64;
  // near a root of high defect H is singular far beyond what first order tells
  const double nearest = small ? 4 : 4096, farthest = small ? 1e15 : 4096;
  double below = s.omega(first), above = s.omega(last);
  for (double factor = nearest; factor <= farthest && (below > lowest || above < highest); factor *= 8) {
    below = std::max(s.omega(first) - factor * movement(s, a, first), lowest);
    above = std::min(s.omega(last) + factor * movement(s, a, last), highest);
    const Inertia low = h.inertia_at(below);
    const Inertia high = h.inertia_at(above);
    if (!low.doubtful() && !high.doubtful()) return high.negative - low.negative;
  }
  return std::nullopt;
}

// Signs of the roots of a cluster: `difference` = p − q of p positive and q negative ones. Pairs of opposite sign get 0
// and 0.
void assign(EnergySigns& signs, Index first, Index last, Index difference) {
  const Index count = last - first + 1;
  const Index surplus = std::abs(difference);
  if (surplus > count || (count - surplus) % 2 != 0) return;  // contradicts the roots found: the forms stand, and the balance will tell
  for (Index i = first; i <= last; ++i)
    signs.sign[static_cast<std::size_t>(i)] = i - first < count - surplus ? 0 : (difference > 0 ? 1 : -1);
  signs.undecided_pairs += (count - surplus) / 2;
}

EnergySigns signs_of_clusters(const Impedance& h, const Spectrum& s, const Assessment& a) {
  EnergySigns signs;
  const Index m = s.omega.size();
  Index jumps = s.size() <= 64 ? m : 8;  // each two factorisations in a large system
  for (Index i = 0; i < m; ++i) signs.sign.push_back(a.form(i) > 0 ? 1 : -1);
  for (Index first = 0, last; first < m; first = last + 1) {
    last = end_of_cluster(s, a, first);
    if (first == last && sure(s, a, first)) continue;
    bool all_sure = true;
    Index difference = 0;
    for (Index i = first; i <= last; ++i) {
      all_sure = all_sure && sure_together(s, a, i);
      difference += signs.sign[static_cast<std::size_t>(i)];
    }
    std::optional<Index> known = all_sure ? signature(h, s, first, last) : std::nullopt;
    if (!known && jumps-- > 0) known = jump(h, s, a, first, last);
    assign(signs, first, last, known.value_or(difference));
  }
  for (Index i = 0; i + 1 < m; ++i) {
    const int product = signs.sign[static_cast<std::size_t>(i)] * signs.sign[static_cast<std::size_t>(i + 1)];
    if (product < 0) signs.gap = std::min(signs.gap, (s.omega(i + 1) - s.omega(i)) / s.omega(i + 1));
  }
  if (signs.undecided_pairs > 0) signs.gap = 0;
  return signs;
}

}  // namespace

EnergySigns energy_signs(const Impedance& h, const Spectrum& s, const Assessment& a) {
  if (h.second_order() && s.stiffness_negative > 0) return signs_of_clusters(h, s, a);
  EnergySigns signs;  // K ≥ 0 (theory §4), or I > 0: energy is positive in every motion
  signs.sign.assign(static_cast<std::size_t>(s.omega.size()), 1);
  return signs;
}

}  // namespace gyromode
