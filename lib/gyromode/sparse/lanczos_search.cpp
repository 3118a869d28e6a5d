#include "gyromode/sparse/lanczos_search.h"

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

}  // namespace

LanczosSearch::LanczosSearch(const SparseSystem& system, const Groups& groups, const Norms& norms, std::unique_ptr<Inverse> inverse,
                             Index wanted)
    : system_(system),
      groups_(groups),
      norms_(norms),
      inverse_(std::move(inverse)),
      lanczos_(*inverse_, system.size(), width, room_for(wanted, inverse_->length() > system.size())),
      tolerance_(1e-8) {}  // in E, relative: residuals of some 10⁻¹¹ (theory sparse §2)

std::vector<Search::Expected> LanczosSearch::look() const {
  const Lanczos::Ritz r = lanczos_.ritz();
  std::vector<Expected> all;
  for (Index k = 0; k < r.theta.size(); ++k) {
    const double square = inverse_->square(r.theta(k));
    if (square > 0) all.push_back({std::sqrt(square), r.residual(k) <= tolerance_ * std::abs(r.theta(k))});
  }
  std::sort(all.begin(), all.end(), [](const Expected& a, const Expected& b) { return a.omega < b.omega; });
  return all;
}

Search::Found LanczosSearch::found(const Window& range) const {
  constexpr double close = 1e-3;  // of what is far from converged nothing is made
  const Lanczos::Ritz r = lanczos_.ritz();
  std::vector<Index> chosen;
  for (Index k = 0; k < r.theta.size(); ++k) {
    const double square = inverse_->square(r.theta(k));
    const bool inside = square > 0 ? range.contains(std::sqrt(square)) : range.a == 0;
    if (inside && r.residual(k) <= close * std::abs(r.theta(k))) chosen.push_back(k);
  }
  Subspace v(system_, groups_.across, groups_.partition);
  for (std::size_t first = 0; first < chosen.size(); first += width) {
    const std::vector<Index> some(chosen.begin() + static_cast<std::ptrdiff_t>(first),
                                  chosen.begin() + static_cast<std::ptrdiff_t>(std::min(first + width, chosen.size())));
    v.add(inverse_->shapes(lanczos_.refined(r.re(Eigen::all, some), passes_)));
    if (r.im.size() > 0) v.add(inverse_->shapes(lanczos_.refined(r.im(Eigen::all, some), passes_)));
  }
  return measured_in(system_, norms_, v, range);
}

}  // namespace gyromode::sparse
