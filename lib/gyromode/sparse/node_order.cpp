#include "gyromode/sparse/node_order.h"

#include "gyromode/base/error.h"

#include <metis.h>

#include <algorithm>
#include <numeric>

namespace gyromode::sparse {

namespace {

// Neighbours of every node, without itself: compressed lists as METIS takes them.
struct Graph {
  std::vector<idx_t> first, neighbour;
};

Graph graph_of(const std::vector<const SparseMatrix*>& patterns, const std::vector<int>& node, int nodes) {
  std::vector<std::pair<int, int>> edges;
  for (const SparseMatrix* pattern : patterns) {
    for (Index j = 0; j < pattern->outerSize(); ++j) {
      const int b = node[static_cast<std::size_t>(j)];
      int last = b;
      for (SparseMatrix::InnerIterator it(*pattern, j); it; ++it) {
        const int a = node[static_cast<std::size_t>(it.row())];
        if (a != b && a != last) edges.emplace_back(std::min(a, b), std::max(a, b));
        last = a;
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  }
  Graph g;
  g.first.assign(static_cast<std::size_t>(nodes) + 1, 0);
  for (const auto& [a, b] : edges) {
    ++g.first[static_cast<std::size_t>(a) + 1];
    ++g.first[static_cast<std::size_t>(b) + 1];
  }
  std::partial_sum(g.first.begin(), g.first.end(), g.first.begin());
  g.neighbour.resize(2 * edges.size());
  std::vector<idx_t> next(g.first.begin(), g.first.end() - 1);
  for (const auto& [a, b] : edges) {
    g.neighbour[static_cast<std::size_t>(next[static_cast<std::size_t>(a)]++)] = b;
    g.neighbour[static_cast<std::size_t>(next[static_cast<std::size_t>(b)]++)] = a;
  }
  return g;
}

}  // namespace

std::vector<int> node_places(const std::vector<const SparseMatrix*>& patterns, const std::vector<int>& node) {
  const int nodes = node.empty() ? 0 : 1 + *std::max_element(node.begin(), node.end());
  Graph g = graph_of(patterns, node, nodes);
  std::vector<idx_t> permutation(static_cast<std::size_t>(nodes)), place(permutation.size());
  std::iota(place.begin(), place.end(), idx_t{0});
  if (!g.neighbour.empty()) {
    idx_t count = nodes, options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;
    if (METIS_NodeND(&count, g.first.data(), g.neighbour.data(), nullptr, options, permutation.data(), place.data()) != METIS_OK)
      throw TooLarge("METIS could not order the graph of the mesh: there is not enough memory");
  }
  return {place.begin(), place.end()};
}

std::vector<int> coordinate_order(const std::vector<int>& places, const std::vector<int>& node) {
  const auto place = [&](int coordinate) { return places[static_cast<std::size_t>(node[static_cast<std::size_t>(coordinate)])]; };
  std::vector<int> by_place(node.size());
  std::iota(by_place.begin(), by_place.end(), 0);
  std::stable_sort(by_place.begin(), by_place.end(), [&](int a, int b) { return place(a) < place(b); });
  std::vector<int> order(node.size());
  for (std::size_t k = 0; k < by_place.size(); ++k) order[static_cast<std::size_t>(by_place[k])] = static_cast<int>(k);
  return order;
}

}  // namespace gyromode::sparse
