#include "gyromode/sparse/arnoldi_search.h"

#include "gyromode/sparse/lanczos.h"
#include "gyromode/sparse/orthonormal.h"

#include <algorithm>
#include <cmath>

namespace gyromode::sparse {

namespace {

constexpr Index block_width = 8;

// Twice the shapes that so many motions have, in phase and in quadrature, and some blocks.
Index room_for(Index wanted) {
  constexpr Index motions = 4, blocks = 12, least = 240;
  return std::max(motions * wanted + blocks * block_width, least);
}

// Roots in the order of their distance from the shift, with how converged they are.
std::vector<Index> nearest(const Vector& omega, double shift) {
  std::vector<Index> order(static_cast<std::size_t>(omega.size()));
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<Index>(k);
  const auto distance = [&](Index k) { return std::abs(omega(k) - shift); };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return distance(a) < distance(b); });
  return order;
}

}  // namespace

ArnoldiSearch::ArnoldiSearch(const SparseSystem& system, const Groups& groups, const Norms& norms, const FreeMotions& free,
                             Resolvent resolvent, Index wanted)
    : system_(system),
      groups_(groups),
      norms_(norms),
      resolvent_(std::move(resolvent)),
      wanted_(wanted),
      most_(room_for(wanted)),
      tolerance_(1e-11),  // of a residual
      v_(system, groups, free) {
  krylov_ = std::make_unique<Krylov>(system_, groups_, resolvent_, v_);
  refresh(block_width);
}

bool ArnoldiSearch::step() {
  if (v_.size() + 2 * block_width > most_) restart();
  applied_ += block_width;
  return krylov_->step();
}

void ArnoldiSearch::refresh(Index columns) {
  if (v_.size() + 2 * columns > most_) restart();
  applied_ += columns;
  krylov_->start(random_shapes(system_.size(), columns, draws_++));
}

std::vector<Search::Expected> ArnoldiSearch::look() const {
  constexpr Index beyond = 8;
  const RitzPairs pairs = ritz_pairs(v_);
  std::vector<Index> chosen = nearest(pairs.omega, resolvent_.shift);
  chosen.resize(std::min<std::size_t>(chosen.size(), static_cast<std::size_t>(wanted_ + beyond)));
  std::sort(chosen.begin(), chosen.end());
  std::vector<Expected> all;
  for (const RitzMode& m : measured(system_, norms_, v_, pairs, chosen)) all.push_back({m.omega, m.residual <= tolerance_});
  return all;
}

Search::Found ArnoldiSearch::found(const Window& range) const { return measured_in(system_, norms_, v_, range); }

// What is kept are the shapes of the motions nearest to the shift, half of what there is room for; the space goes on
// from those nearest that have not converged.
void ArnoldiSearch::restart() {
  const RitzPairs pairs = ritz_pairs(v_);
  const std::vector<Index> order = nearest(pairs.omega, resolvent_.shift);
  const Index p = v_.size(), kept = std::min<Index>(static_cast<Index>(order.size()), most_ / 4), growing = pairs.unstable.count();
  Matrix parts(p, 2 * (kept + growing));
  std::vector<Index> chosen(order.begin(), order.begin() + kept);
  for (Index k = 0; k < kept; ++k) {
    parts.col(2 * k) = pairs.coefficients.col(order[static_cast<std::size_t>(k)]).real();
    parts.col(2 * k + 1) = pairs.coefficients.col(order[static_cast<std::size_t>(k)]).imag();
  }
  for (Index k = 0; k < growing; ++k) {
    parts.col(2 * (kept + k)) = pairs.unstable.right.col(k).real();
    parts.col(2 * (kept + k) + 1) = pairs.unstable.right.col(k).imag();
  }
  const std::vector<RitzMode> modes = measured(system_, norms_, v_, pairs, chosen);
  Matrix q(system_.size(), block_width), velocity(system_.size(), block_width);
  Index at = 0;
  for (const RitzMode& m : modes) {
    if (at == block_width) break;
    if (m.residual <= tolerance_) continue;
    q.col(at) = m.shape.real();
    velocity.col(at++) = -m.omega * m.shape.imag();
  }
  v_.keep(parts);
  krylov_->restart(q.leftCols(at), velocity.leftCols(at));
  if (at == 0) krylov_->start(random_shapes(system_.size(), block_width, draws_++));
  applied_ += block_width;
}

}  // namespace gyromode::sparse
