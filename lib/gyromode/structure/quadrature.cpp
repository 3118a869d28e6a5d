#include "gyromode/structure/quadrature.h"

#include <algorithm>

namespace gyromode {

namespace {

constexpr Index none = -1;

// Breadth-first search tree: parent, the coupling that led here, depth and colour of every coordinate reached.
struct WalkNode {
  Index parent = none;
  CouplingKind kind = CouplingKind::in_phase;
  Index depth = 0;
  int colour = none;
};

class WalkSearch {
 public:
  explicit WalkSearch(const CouplingGraph& graph) : graph_(graph), nodes_(graph.neighbours.size()) {}

  bool reached(Index v) const { return node(v).colour != none; }

  Component grow(Index root) {
    Component c;
    std::vector<Index> queue{root};
    node(root).colour = 0;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const Index v = queue[head];
      for (const auto& edge : graph_.neighbours[static_cast<std::size_t>(v)]) {
        const int colour = edge.kind == CouplingKind::cross ? 1 - node(v).colour : node(v).colour;
        if (!reached(edge.to)) {
          node(edge.to) = {v, edge.kind, node(v).depth + 1, colour};
          queue.push_back(edge.to);
        } else if (node(edge.to).colour != colour && !c.odd_cycle) {
          c.odd_cycle = close_cycle(v, edge);
        }
      }
    }
    std::sort(queue.begin(), queue.end());
    if (!c.odd_cycle) {
      for (const Index v : queue) (node(v).colour == 0 ? c.in_phase : c.in_quadrature).push_back(v);
    }
    c.coordinates = std::move(queue);
    return c;
  }

 private:
  WalkNode& node(Index v) { return nodes_[static_cast<std::size_t>(v)]; }
  const WalkNode& node(Index v) const { return nodes_[static_cast<std::size_t>(v)]; }

  // The tree paths of v and edge.to up to their lowest common ancestor, joined by the edge that contradicts the
  // colours.
  OddCycle close_cycle(Index v, const CouplingGraph::Edge& edge) const {
    std::vector<Index> down{v};      // v, parent(v), … , ancestor
    std::vector<Index> up{edge.to};  // edge.to, parent, … , ancestor
    while (down.back() != up.back()) {
      auto& deeper = node(down.back()).depth >= node(up.back()).depth ? down : up;
      deeper.push_back(node(deeper.back()).parent);
    }
    OddCycle cycle;  // ancestor → … → v → edge.to → … → ancestor
    for (std::size_t k = down.size(); k-- > 0;) {
      cycle.coordinates.push_back(down[k]);
      if (k > 0) cycle.kinds.push_back(node(down[k - 1]).kind);
    }
    cycle.kinds.push_back(edge.kind);
    for (std::size_t k = 0; k + 1 < up.size(); ++k) {
      cycle.coordinates.push_back(up[k]);
      cycle.kinds.push_back(node(up[k]).kind);
    }
    return cycle;
  }

  const CouplingGraph& graph_;
  std::vector<WalkNode> nodes_;
};

}  // namespace

std::vector<Component> partition(const CouplingGraph& graph) {
  std::vector<Component> components;
  WalkSearch search(graph);
  for (Index v = 0; v < graph.size(); ++v) {
    if (!search.reached(v)) components.push_back(search.grow(v));
  }
  return components;
}

}  // namespace gyromode
