#include "gyromode/structure/coupling.h"

namespace gyromode {

namespace {

// Column v of a matrix with a symmetric pattern holds the couplings of v.
void add_couplings(std::vector<CouplingGraph::Edge>& neighbours, const Matrix& a, Index v, CouplingKind kind) {
  for (Index i = 0; i < a.rows(); ++i) {
    if (i != v && a(i, v) != 0) neighbours.push_back({static_cast<std::int32_t>(i), kind});
  }
}

std::size_t couplings(const Matrix& a, Index v) { return static_cast<std::size_t>((a.col(v).array() != 0).count()); }

}  // namespace

CouplingGraph coupling_graph(const std::vector<const Matrix*>& symmetric, const Matrix& skew) {
  CouplingGraph graph;
  graph.neighbours.resize(static_cast<std::size_t>(skew.rows()));
  for (Index v = 0; v < graph.size(); ++v) {
    auto& neighbours = graph.neighbours[static_cast<std::size_t>(v)];
    std::size_t count = couplings(skew, v);
    for (const Matrix* a : symmetric) count += couplings(*a, v);
    neighbours.reserve(count);
    for (const Matrix* a : symmetric) add_couplings(neighbours, *a, v, CouplingKind::in_phase);
    add_couplings(neighbours, skew, v, CouplingKind::cross);
  }
  return graph;
}

}  // namespace gyromode
