#include "gyromode/sparse/lanczos_search.h"

#include "gyromode/sparse/motions.h"
#include "gyromode/sparse/subspace.h"

#include <algorithm>
#include <cmath>

namespace gyromode::sparse {

namespace {

constexpr Index width = 8;  // blocks of 4 and 16 are slower (theory sparse §2)

// Columns that a window of so many roots is found with: twice their number and some blocks.
Index room_for(Index wanted, bool pairs) {
  constexpr Index blocks = 6;
  return (pairs ? 2 : 1) * (2 * wanted) + blocks * width;
}

std::vector<Index> some_of(const std::vector<Index>& all, std::size_t first) {
  const std::size_t last = std::min(first + static_cast<std::size_t>(width), all.size());
  return {all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(last)};
}

}  // namespace

LanczosSearch::LanczosSearch(const SparseSystem& system, const Groups& groups, const Norms& norms, const FreeMotions& free,
                             std::unique_ptr<Inverse> inverse, std::vector<double> beside, Index wanted)
    : system_(system),
      groups_(groups),
      norms_(norms),
      free_(free),
      inverse_(std::move(inverse)),
      beside_(std::move(beside)),
      lanczos_(*inverse_, system.size(), width, room_for(wanted, inverse_->length() > system.size())),
      stiffest_(system.stiffness().diagonal().cwiseQuotient(system.mass().diagonal()).cwiseAbs().maxCoeff()) {}

// In E a residual of 10⁻⁸ is enough for what is far from the shift in the spectrum, as the operator makes that smaller
// (theory sparse §2). Of roots as near as the one in question its part in H(ω)X is |σ² − ω²| of it, beside ‖K‖.
double LanczosSearch::tolerance(double theta) const {
  constexpr double far = 1e-8, near = 1e-11;
  const double distance = inverse_->skew() ? 1 / (theta * theta) : 1 / std::abs(theta);  // |σ² − ω²|
  return std::min(far, near * stiffest_ / distance);
}

std::vector<Search::Expected> LanczosSearch::look() const {
  const Lanczos::Ritz r = lanczos_.ritz();
  std::vector<Expected> all;
  for (Index k = 0; k < r.theta.size(); ++k) {
    const double square = inverse_->square(r.theta(k));
    if (square > 0) all.push_back({std::sqrt(square), r.residual(k) <= tolerance(r.theta(k)) * std::abs(r.theta(k))});
  }
  std::sort(all.begin(), all.end(), [](const Expected& a, const Expected& b) { return a.omega < b.omega; });
  return all;
}

// Roots off the axis, and states of which several belong to one motion, by a projection on what they span; the others
// as they are.
Search::Found LanczosSearch::found(const Window& range) const {
  constexpr double close = 1e-6;  // of what is far from converged nothing is made
  const Lanczos::Ritz r = lanczos_.ritz();
  std::vector<Index> on_axis, spanned;
  std::vector<double> omega = beside_;
  for (Index k = 0; k < r.theta.size(); ++k) {
    const double square = inverse_->square(r.theta(k));
    if (square > 0) omega.push_back(std::sqrt(square));
    if (r.residual(k) > close * std::abs(r.theta(k))) continue;
    if (square > 0 && range.contains(omega.back())) (inverse_->motions() ? on_axis : spanned).push_back(k);
    if (square <= 0 && range.a == 0) spanned.push_back(k);
  }
  Found f = measured_motions(r, on_axis, omega);
  if (spanned.empty()) return f;
  Subspace v(system_, groups_, free_);
  for (std::size_t first = 0; first < spanned.size(); first += width) {
    const std::vector<Index> which = some_of(spanned, first);
    v.add(inverse_->shapes(lanczos_.refined(lanczos_.combined(r.re(Eigen::all, which)), r, which)));
  }
  Found projected = measured_in(system_, norms_, v, range);
  f.unstable = std::move(projected.unstable);
  if (!inverse_->motions()) f.modes = std::move(projected.modes);
  return f;
}

// The operator is applied once to what Lanczos made, and again to the motions that come of it, separated, as long as
// one that should have converged has not to what is asked of a result.
Search::Found LanczosSearch::measured_motions(const Lanczos::Ritz& r, const std::vector<Index>& chosen, std::vector<double> omega) const {
  constexpr int most_passes = 3;
  std::sort(omega.begin(), omega.end());
  const Vector all = Eigen::Map<const Vector>(omega.data(), static_cast<Index>(omega.size()));
  const StateKind kind{r.im.size() > 0, inverse_->leading_group()};
  const Index m = static_cast<Index>(chosen.size());
  const auto in_order = [&](const Matrix& u) { return kind.pairs ? u : inverse_->shapes(u); };
  const auto each_piece = [&](const auto& see) {
    for (Index at = 0; at < m; at += width) see(at, std::min<Index>(width, m - at));
  };
  Matrix first(inverse_->length(), m), second(inverse_->length(), kind.pairs ? m : 0);
  each_piece([&](Index at, Index some) {
    const std::vector<Index> which = some_of(chosen, static_cast<std::size_t>(at));
    first.middleCols(at, some) = in_order(lanczos_.refined(lanczos_.combined(r.re(Eigen::all, which)), r, which));
    if (kind.pairs) second.middleCols(at, some) = lanczos_.refined(lanczos_.combined(r.im(Eigen::all, which)), r, which);
  });
  const Vector expected = r.theta(chosen).unaryExpr([&](double theta) { return std::sqrt(inverse_->square(theta)); });
  Found f;
  for (int pass = 1;; ++pass) {
    ShapeBlock found = motions_of(groups_, kind, expected, first, second);
    if (groups_.partition) complete(free_, kind.leads, expected, found.re, found.im);
    f.modes = measured(system_, groups_, norms_, found, all);
    bool good = true;
    for (Index k = 0; k < m; ++k) {
      const Index c = chosen[static_cast<std::size_t>(k)];
      good = good && (r.residual(c) > tolerance(r.theta(c)) * std::abs(r.theta(c)) || converged(f.modes[static_cast<std::size_t>(k)]));
    }
    if (good || pass == most_passes) break;
    each_piece([&](Index at, Index some) {
      ShapeBlock block{Vector(some), Matrix(system_.size(), some), Matrix(system_.size(), some)};
      for (Index k = 0; k < some; ++k) {
        const RitzMode& mode = f.modes[static_cast<std::size_t>(at + k)];
        block.omega(k) = mode.omega;
        block.re.col(k) = mode.shape.real();
        block.im.col(k) = mode.shape.imag();
      }
      StatesOfMotions s = states_of(groups_, kind, block);
      const Matrix u = kind.pairs ? std::move(s.first) : inverse_->states(s.first);
      const std::vector<Index> which = some_of(chosen, static_cast<std::size_t>(at));
      first.middleCols(at, some) = in_order(lanczos_.refined(u, r, which));
      if (kind.pairs) second.middleCols(at, some) = lanczos_.refined(s.second, r, which);
    });
  }
  std::sort(f.modes.begin(), f.modes.end(), [](const RitzMode& a, const RitzMode& b) { return a.omega < b.omega; });
  return f;
}

}  // namespace gyromode::sparse
