#include "gyromode/sparse/node_order.h"

#include "gyromode/base/error.h"

#include <metis.h>

#include <algorithm>
#include <numeric>

namespace gyromode::sparse {

namespace {

// Compressed lists, as METIS takes them: that of k are the entries first[k] to first[k + 1].
struct Lists {
  std::vector<idx_t> first, entries;
};

// The members of every group, of the group of every member.
Lists grouped(const std::vector<int>& of, int groups) {
  Lists g;
  g.first.assign(static_cast<std::size_t>(groups) + 1, 0);
  for (const int k : of) ++g.first[static_cast<std::size_t>(k) + 1];
  std::partial_sum(g.first.begin(), g.first.end(), g.first.begin());
  g.entries.resize(of.size());
  std::vector<idx_t> next(g.first.begin(), g.first.end() - 1);
  for (std::size_t member = 0; member < of.size(); ++member)
    g.entries[static_cast<std::size_t>(next[static_cast<std::size_t>(of[member])]++)] = static_cast<idx_t>(member);
  return g;
}

// The neighbours of every node, without itself, ascending: rows that the columns of each node have, once each; then the
// same from the rows to the columns, and what is there twice once.
Lists graph_of(const std::vector<const SparseMatrix*>& patterns, const std::vector<int>& node, int nodes) {
  const Lists coordinates = grouped(node, nodes);
  std::vector<int> seen(static_cast<std::size_t>(nodes), -1), from, to;
  for (int b = 0; b < nodes; ++b) {
    for (idx_t k = coordinates.first[static_cast<std::size_t>(b)]; k < coordinates.first[static_cast<std::size_t>(b) + 1]; ++k) {
      for (const SparseMatrix* pattern : patterns) {
        for (SparseMatrix::InnerIterator it(*pattern, coordinates.entries[static_cast<std::size_t>(k)]); it; ++it) {
          const int a = node[static_cast<std::size_t>(it.row())];
          if (a == b || seen[static_cast<std::size_t>(a)] == b) continue;
          seen[static_cast<std::size_t>(a)] = b;
          from.insert(from.end(), {a, b});
          to.insert(to.end(), {b, a});
        }
      }
    }
  }
  Lists g = grouped(from, nodes);
  std::fill(seen.begin(), seen.end(), -1);
  std::size_t end = 0;
  for (int b = 0; b < nodes; ++b) {
    const auto first = static_cast<std::size_t>(g.first[static_cast<std::size_t>(b)]);
    const auto last = static_cast<std::size_t>(g.first[static_cast<std::size_t>(b) + 1]);
    g.first[static_cast<std::size_t>(b)] = static_cast<idx_t>(end);
    for (std::size_t k = first; k < last; ++k) {
      const int a = to[static_cast<std::size_t>(g.entries[k])];
      if (seen[static_cast<std::size_t>(a)] == b) continue;
      seen[static_cast<std::size_t>(a)] = b;
      g.entries[end++] = a;
    }
    std::sort(g.entries.begin() + static_cast<std::ptrdiff_t>(g.first[static_cast<std::size_t>(b)]),
              g.entries.begin() + static_cast<std::ptrdiff_t>(end));
  }
  g.first[static_cast<std::size_t>(nodes)] = static_cast<idx_t>(end);
  g.entries.resize(end);
  return g;
}

}  // namespace

std::vector<int> node_places(const std::vector<const SparseMatrix*>& patterns, const std::vector<int>& node) {
  const int nodes = node.empty() ? 0 : 1 + *std::max_element(node.begin(), node.end());
  Lists g = graph_of(patterns, node, nodes);
  std::vector<idx_t> permutation(static_cast<std::size_t>(nodes)), place(permutation.size());
  std::iota(place.begin(), place.end(), idx_t{0});
  if (!g.entries.empty()) {
    idx_t count = nodes, options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;
    if (METIS_NodeND(&count, g.first.data(), g.entries.data(), nullptr, options, permutation.data(), place.data()) != METIS_OK)
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
