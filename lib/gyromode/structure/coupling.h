#pragma once

#include "gyromode/structure/structure.h"

#include <cstdint>
#include <vector>

namespace gyromode {

/// The couplings of n coordinates as an undirected graph, one list of neighbours a coordinate.
struct CouplingGraph {
  struct Edge {  // of eight bytes: a full matrix has many
    std::int32_t to;
    CouplingKind kind;
  };
  std::vector<std::vector<Edge>> neighbours;

  Index size() const { return static_cast<Index>(neighbours.size()); }
};

/// Entry a_ij ≠ 0 couples i and j, however small (without_ignored_couplings() leaves small ones out). `symmetric` are
/// the matrices that couple in phase (M and K, or I), `skew` the one that couples across (G).
CouplingGraph coupling_graph(const std::vector<const Matrix*>& symmetric, const Matrix& skew);

}  // namespace gyromode
