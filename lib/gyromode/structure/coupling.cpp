#include "gyromode/structure/coupling.h"

namespace gyromode {

namespace {

void add_couplings(CouplingGraph& graph, const Matrix& a, CouplingKind kind) {
  for (Index j = 0; j < a.cols(); ++j) {
    for (Index i = j + 1; i < a.rows(); ++i) {
      if (a(i, j) == 0) continue;
      graph.neighbours[static_cast<std::size_t>(i)].push_back({j, kind});
      graph.neighbours[static_cast<std::size_t>(j)].push_back({i, kind});
    }
  }
}

}  // namespace

CouplingGraph coupling_graph(const std::vector<const Matrix*>& symmetric, const Matrix& skew) {
  CouplingGraph graph;
  graph.neighbours.resize(static_cast<std::size_t>(skew.rows()));
  for (const Matrix* a : symmetric) add_couplings(graph, *a, CouplingKind::in_phase);
  add_couplings(graph, skew, CouplingKind::cross);
  return graph;
}

}  // namespace gyromode
