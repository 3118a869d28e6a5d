#include "gyromode/modes/sparse_balance.h"

#include "gyromode/base/error.h"
#include "gyromode/modes/sparse_modes.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/subspace.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode {

namespace {

constexpr Index most_negative = 300;  // of n₋(K): so many motions are looked for, one by one

}  // namespace

SparseBalance::SparseBalance(const SparseSystem& system, const sparse::Searches& searches, const Progress& progress)
    : system_(system), searches_(searches) {
  index_.negative = searches_.negative_stiffness();
  index_.zero = searches_.free().zero_pairs();
  index_.zero_negative = searches_.free().negative;
  index_.closed = exhibited() == index_.negative && !searches_.free().doubtful;
  if (!index_.closed && index_.negative <= most_negative) close(progress);
}

bool SparseBalance::take(const sparse::MeasuredRoots& found) {
  if (found.stopped) throw Interrupted();
  constexpr double shown = 10, residual = 1e-11;
  negative_.clear();
  unstable_.clear();
  for (const sparse::RitzMode& m : found.modes) {
    if (m.energy_sign < 0 && sparse::converged(m)) negative_.push_back(m);
  }
  for (const sparse::RitzUnstable& u : found.unstable) {
    if (u.residual <= residual && u.lambda.real() > shown * u.error_bound) unstable_.push_back(u);
  }
  index_.real_pairs = std::count_if(unstable_.begin(), unstable_.end(), [](const auto& u) { return u.lambda.imag() == 0; });
  index_.quadruples = static_cast<Index>(unstable_.size()) - index_.real_pairs;
  index_.negative_energy = static_cast<Index>(negative_.size());
  index_.closed = exhibited() == index_.negative && !searches_.free().doubtful;
  return index_.closed;
}

// Motions of negative energy have ω < γ/2, γ ≥ ‖M^−½GM^−½‖, as 2ω XᴴMX < Xᴴ(jG)X: none is looked for beyond.
void SparseBalance::close(const Progress& progress) {
  const double farthest = 0.5 * system_.gyroscopic_bound().value_or(system_.gyroscopic_size());
  sparse::Goal goal;
  if (system_.gyroscopic_bound()) goal.range.b = farthest;
  goal.enough = [&](const auto&) { return std::optional<Window>(goal.range); };
  goal.accepted = [&](const sparse::MeasuredRoots& f) { return take(f); };
  goal.missing = index_.negative;
  goal.most_applied = most_applied(index_.negative);
  take(search_for(searches_.about_zero(index_.negative + 8), goal, progress));
  if (!index_.closed && farthest > 0) close_farther(farthest, progress);
}

// Where what is near 0 does not close the balance shifts up to there are tried. Of searches that found the same motion
// one remains, by a projection on the shapes of all.
void SparseBalance::close_farther(double farthest, const Progress& progress) {
  sparse::Subspace shapes(system_, searches_.groups(), searches_.free());
  const auto keep = [&] {
    for (const sparse::RitzMode& m : negative_) shapes.add(sparse::parts_of(m.shape));
    for (const sparse::RitzUnstable& u : unstable_) shapes.add(sparse::parts_of(u.shape));
  };
  keep();
  sparse::Goal goal;
  if (system_.gyroscopic_bound()) goal.range.b = farthest;
  goal.enough = [](const auto&) { return std::optional<Window>(); };
  goal.missing = index_.negative;
  goal.most_applied = most_applied(index_.negative) / 4;
  for (const double part : {0.5, 0.25, 0.75, 1.0}) {
    const auto search = searches_.about(part * farthest, index_.negative + 8);
    take(search_for(*search, goal, progress));
    keep();
    if (take(measured_in(system_, searches_.norms(), shapes, {}))) return;
  }
}

std::string SparseBalance::open_reason() const {
  if (searches_.free().doubtful)
    return "what G makes of the null space of K, or a sign of the form that decides on its motions, comes within rounding of zero";
  if (index_.negative > most_negative)
    return fmt::format("n₋(K) = {}: the motions that take so many negative directions are not looked for beyond {}", index_.negative,
                       most_negative);
  return fmt::format("the index balance does not close: of n₋(K) = {} the motions found near ω = 0 make {}", index_.negative, exhibited());
}

Index SparseBalance::missed_by_signs(const Window& range) const {
  return 2 * std::count_if(negative_.begin(), negative_.end(), [&](const auto& m) { return range.contains(m.omega); });
}

}  // namespace gyromode
