#include "gyromode/sparse/partition.h"

#include "gyromode/structure/coupling.h"
#include "gyromode/structure/quadrature.h"

namespace gyromode::sparse {

Structure analyse(const SparseMatrices& m) {
  CouplingGraph graph;
  graph.neighbours.resize(static_cast<std::size_t>(m.mass.cols()));
  for (const auto& [a, kind] :
       {std::pair(&m.stiffness, CouplingKind::in_phase), {&m.mass, CouplingKind::in_phase}, {&m.gyroscopic, CouplingKind::cross}}) {
    for (Index j = 0; j < a->outerSize(); ++j) {
      for (SparseMatrix::InnerIterator it(*a, j); it; ++it) {
        const Index i = it.row();
        if (i == j || it.value() == 0) continue;
        graph.neighbours[static_cast<std::size_t>(i)].push_back({static_cast<std::int32_t>(j), kind});
        graph.neighbours[static_cast<std::size_t>(j)].push_back({static_cast<std::int32_t>(i), kind});
      }
    }
  }
  return {partition(graph)};
}

}  // namespace gyromode::sparse
