#include "gyromode/structure/coupling.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

void add_couplings(CouplingGraph& graph, const Matrix& a, CouplingKind kind, double tolerance) {
  const double largest = a.size() == 0 ? 0 : a.cwiseAbs().maxCoeff();
  for (Index j = 0; j < a.cols(); ++j) {
    for (Index i = j + 1; i < a.rows(); ++i) {
      const double size = std::abs(a(i, j));
      if (size == 0) continue;
      if (size <= tolerance * largest) {
        graph.largest_ignored = std::max(graph.largest_ignored, size / largest);
        continue;
      }
      graph.neighbours[static_cast<std::size_t>(i)].push_back({j, kind});
      graph.neighbours[static_cast<std::size_t>(j)].push_back({i, kind});
    }
  }
}

}  // namespace

CouplingGraph coupling_graph(const std::vector<const Matrix*>& symmetric, const Matrix& skew, double tolerance) {
  CouplingGraph graph;
  graph.neighbours.resize(static_cast<std::size_t>(skew.rows()));
  for (const Matrix* a : symmetric) add_couplings(graph, *a, CouplingKind::in_phase, tolerance);
  add_couplings(graph, skew, CouplingKind::cross, tolerance);
  return graph;
}

}  // namespace gyromode
