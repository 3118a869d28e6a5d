#pragma once

#include "gyromode/modes/sparse_counts.h"

namespace gyromode {

/// Modes of windows of a sparse system, as many as are counted there, about shifts.
class SparseWindows {
 public:
  SparseWindows(const sparse::Searches& searches, const SparseCounts& counts, const Progress& progress)
      : searches_(searches), counts_(counts), progress_(progress) {}

  /// As many modes of [a, b) as are expected there, or those that were found.
  SparseModes between(double a, double b, Index expected, int depth = 3) const;

 private:
  SparseModes halves(double a, double b, double middle, int depth) const;
  SparseModes about(double sigma, double a, double b, Index expected) const;
  SparseModes from_both_ends(double a, double b, Index expected) const;

  const sparse::Searches& searches_;
  const SparseCounts& counts_;
  const Progress& progress_;
};

}  // namespace gyromode
