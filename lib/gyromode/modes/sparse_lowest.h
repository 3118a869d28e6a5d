#pragma once

#include "gyromode/modes/sparse_windows.h"

namespace gyromode {

/// The lowest so many modes of a sparse system, and some beyond.
class SparseLowest {
 public:
  SparseLowest(const SparseSystem& system, const sparse::Searches& searches, const SparseBalance& balance, SparseCounts& counts,
               const Progress& progress)
      : system_(system), searches_(searches), balance_(balance), counts_(counts), progress_(progress) {}

  struct Found {
    SparseModes modes;              ///< ascending
    double all_below = 0;           ///< all below that are there, as far as counts can tell; 0: where `modes` ends
    double known_below = infinity;  ///< the user stopped the work: modes from here on were not looked for
  };
  /// At least `count` of them below range.b, where there are so many. @throws NotConverged where none is found
  Found lowest(Index count, const Window& range) const;

 private:
  sparse::MeasuredRoots near_zero(Index wanted, const Window& range) const;
  /// Counts at rest that those are all (theory T17). False where it does not close.
  bool close_at_rest(const SparseModes& lowest, Index wanted) const;
  bool counted_in_gap(const SparseModes& low, Index count) const;
  Found by_windows(Index count, double start, double last) const;

  const SparseSystem& system_;
  const sparse::Searches& searches_;
  const SparseBalance& balance_;
  SparseCounts& counts_;
  const Progress& progress_;
};

}  // namespace gyromode
