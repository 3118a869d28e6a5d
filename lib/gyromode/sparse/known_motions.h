#pragma once

#include "gyromode/sparse/deflated.h"
#include "gyromode/sparse/search.h"

#include <memory>
#include <optional>
#include <vector>

namespace gyromode::sparse {

/// Motions that are known before a search: all that the energy E = diag(K, M) is not positive on. On what is
/// E-orthogonal to them it is definite, whatever K is, as n₋(E) is the sum of those of both parts; that they are known
/// to rounding alone changes the roots of the others to second order in it.
struct KnownMotions {
  std::vector<RitzMode> modes;         ///< of negative energy, ascending
  std::vector<RitzUnstable> unstable;  ///< growing

  bool any() const { return !modes.empty() || !unstable.empty(); }
};

/// Their states in the order of coordinates, as an operator that begins with the group `leads` has them, and E times
/// them: with a partition of a mode one, of flutter two, which it has in common with what decays; else of a mode two
/// (growing motions are not asked for).
States states_of_known(const KnownMotions& known, const SparseSystem& system, const Groups& groups, Index leads);

/// What takes them away E-orthogonally. Nothing where E has not `negative` negative eigenvalues on them, so that it is
/// not definite on the rest, or comes near to zero on one.
std::optional<TakenAway> orthogonal_to(const States& known, Index negative);

/// A search on what is beside known motions, with these among what it finds.
class SearchBeside : public Search {
 public:
  SearchBeside(std::unique_ptr<Search> rest, const KnownMotions& known) : rest_(std::move(rest)), known_(known) {}

  bool step() override { return rest_->step(); }
  void refresh(Index width) override { rest_->refresh(width); }
  std::vector<Expected> look() const override;
  Found found(const Window& range) const override;
  Index applied() const override { return rest_->applied(); }

 private:
  std::unique_ptr<Search> rest_;
  const KnownMotions& known_;
};

}  // namespace gyromode::sparse
