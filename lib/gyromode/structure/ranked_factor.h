#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode {

/// What a symmetric matrix K is, entry by entry: P K Pᵀ = L D Lᵀ with complete pivoting (Bunch & Parlett 1971), which
/// ends where all that is left of a Schur complement is below rounding of the terms that it is made of. Each entry is
/// judged by its own terms, so units and gradings of the coordinates do not matter, and a small pivot that nothing was
/// subtracted from is as good as a large one.
struct RankedFactor {
  Index negative = 0, positive = 0;
  std::vector<Index> regular;  ///< coordinates of the pivots, in their order: K restricted to them is regular
  std::vector<Index> free;     ///< the other coordinates: as many as K has zero eigenvalues
  Matrix null_space;           ///< n × free: KN = 0, the unit matrix in the rows `free`
  double smallest_kept = 1;    ///< of all pivots the least |pivot| / (sum of the sizes of its terms): 1 where nothing cancelled
  double largest_dropped = 0;  ///< of all entries of what is left the largest such ratio

  Index zero() const { return static_cast<Index>(free.size()); }
  /// Whether zero may be taken for a pivot or a pivot for zero: kept ratios below 64 n ε, where what is called zero
  /// ends at 8 n ε, or what is left has more than 4 n ε.
  bool doubtful() const;
};

/// `terms`: the size of what each entry of K was computed from (entry_scale(K) where K was given): its rounding error
/// is some ε of that. n × n.
RankedFactor ranked_factor(const Matrix& k, const Matrix& terms);
RankedFactor ranked_factor(const Matrix& k);

}  // namespace gyromode
