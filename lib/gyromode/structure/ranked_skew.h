#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode {

/// What a real skew matrix S is, entry by entry: pairs of pivots ±g by complete pivoting, until all that is left is
/// below rounding of the terms that it is made of (as in RankedFactor). The zero pattern of a partition (S couples two
/// groups, and nothing within one) is kept.
struct RankedSkew {
  std::vector<Index> regular;  ///< the pivots, two by two: S restricted to them is regular
  std::vector<Index> free;     ///< the others: dim null(S)
  Matrix null_space;           ///< n × free, the unit matrix in the rows `free`
  double smallest_kept = 1;    ///< the least |pivot| over its terms
};

/// `terms`: the size of what each entry was computed from. n × n.
RankedSkew ranked_skew(Matrix s, Matrix terms);
/// NᵀGN of a skew G (n × n) on the columns of N, its terms |N|ᵀ entry_scale(G) |N|.
RankedSkew ranked_skew_on(const Matrix& g, const Matrix& columns);

}  // namespace gyromode
