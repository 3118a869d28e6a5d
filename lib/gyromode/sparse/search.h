#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/sparse/ritz.h"
#include "gyromode/spectrum/window.h"

#include <functional>
#include <optional>
#include <vector>

namespace gyromode::sparse {

/// Roots about a shift, by a space that grows.
class Search {
 public:
  virtual ~Search() = default;

  /// A root as the space knows it by now, before it is measured.
  struct Expected {
    double omega = 0;
    bool converged = false;
  };
  using Found = MeasuredRoots;

  /// One block more. @returns false where nothing new comes
  virtual bool step() = 0;
  /// Goes on from `width` shapes that have nothing to do with those before.
  virtual void refresh(Index width) = 0;
  virtual std::vector<Expected> look() const = 0;  ///< ascending
  virtual Found found(const Window& range) const = 0;
  virtual Index applied() const = 0;  ///< columns solved for
};

/// Whether a root that was measured is one: its residual, a third of what is asked of a result.
bool converged(const RitzMode& m);

/// What a search is made to find, and when it gives up.
struct Goal {
  Window range;  ///< the roots wanted
  /// Of those of the range: what is to be measured now, or nothing where there is not enough yet.
  std::function<std::optional<Window>(const std::vector<Search::Expected>& inside)> enough;
  /// Of what was measured; null: as many have converged as were expected to have. Roots of a projection may be none.
  std::function<bool(const Search::Found&)> accepted = nullptr;
  Index missing = 0;       ///< about how many there are
  Index most_applied = 0;  ///< columns
};

/// Grows the space until there is enough and it is accepted, or nothing new comes, or work has come to its end. Where
/// all in range has converged and more must be there, it goes on from new shapes: roots of one frequency may be more
/// than a block has columns. Where the user stops it, what has converged from the beginning of the range on.
Search::Found search_for(Search& search, const Goal& goal, const Progress& progress);

}  // namespace gyromode::sparse
