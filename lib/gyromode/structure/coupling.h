#pragma once

#include "gyromode/lapack/types.h"

#include <vector>

namespace gyromode {

/// How two coordinates are coupled: `in_phase` through M or K (real entries of H), `cross` through G (imaginary entries).
enum class CouplingKind { in_phase, cross };

/// The couplings of n coordinates as an undirected graph, one list of neighbours a coordinate.
struct CouplingGraph {
  struct Edge {
    Index to;
    CouplingKind kind;
  };
  std::vector<std::vector<Edge>> neighbours;
  double largest_ignored = 0;  ///< largest |a_ij| / max |a| that `tolerance` treated as no coupling, over all matrices

  Index size() const { return static_cast<Index>(neighbours.size()); }
};

/// Entry a_ij couples i and j where |a_ij| > tolerance · max |a|, in each matrix by itself; the default 0 lets nothing through.
/// `symmetric` are the matrices that couple in phase (M and K, or I), `skew` the one that couples across (G).
CouplingGraph coupling_graph(const std::vector<const Matrix*>& symmetric, const Matrix& skew, double tolerance = 0);

}  // namespace gyromode
