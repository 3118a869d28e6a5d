#pragma once

#include "gyromode/modes/sparse_counts.h"

namespace gyromode {

/// Modes of windows of a sparse system, as many as are counted there, about shifts.
class SparseWindows {
 public:
  SparseWindows(const sparse::Searches& searches, const SparseCounts& counts, const Progress& progress)
      : searches_(searches), counts_(counts), progress_(progress) {}

  /// As many modes of [a, b) as are expected there, or those that were found.
  SparseModes between(double a, double b, Index expected);
  /// Where the user stopped the work: no mode below that is missing as far as searches can tell. Else infinite.
  double known_below() const { return known_below_; }

 private:
  SparseModes searched(double a, double b, Index expected, int depth);
  SparseModes halves(double a, double b, double middle, int depth);
  SparseModes about(double sigma, double a, double b, Index expected);
  SparseModes from_both_ends(double a, double b, Index expected);
  bool stopped() const { return known_below_ < infinity; }
  /// Of a search from the beginning of a window.
  SparseModes stopped_at(SparseModes modes, double a);

  const sparse::Searches& searches_;
  const SparseCounts& counts_;
  const Progress& progress_;
  double known_below_ = infinity;
};

}  // namespace gyromode
