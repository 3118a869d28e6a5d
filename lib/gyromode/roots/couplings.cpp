#include "gyromode/roots/couplings.h"

#include <algorithm>
#include <numeric>

namespace gyromode {

Couplings::Couplings(Index size) : first_of_equals_(static_cast<std::size_t>(size)) {
  graph_.neighbours.resize(static_cast<std::size_t>(size));
  std::iota(first_of_equals_.begin(), first_of_equals_.end(), Index{0});
}

void Couplings::add(Index i, Index k, CouplingKind kind) {
  if (i == k || meet(i, k, kind)) return;
  graph_.neighbours[static_cast<std::size_t>(i)].push_back({static_cast<std::int32_t>(k), kind});
  graph_.neighbours[static_cast<std::size_t>(k)].push_back({static_cast<std::int32_t>(i), kind});
}

bool Couplings::meet(Index i, Index k, CouplingKind kind) const {
  const auto& of_i = graph_.neighbours[static_cast<std::size_t>(i)];
  return std::any_of(of_i.begin(), of_i.end(), [&](const CouplingGraph::Edge& e) { return e.to == k && e.kind == kind; });
}

}  // namespace gyromode
