#include "gyromode/structure/phases.h"

#include <cmath>
#include <vector>

namespace gyromode {

namespace {

constexpr double stands_out = 10;

// arg d_i = sign·φ + offset, φ that of the root.
struct TreeNode {
  double sign = 0, offset = 0;
};

// Grows the tree of `root` by Prim's rule; the nodes in the order in which they came.
std::vector<Index> grow(const Matrix& strength, const ComplexMatrix& w, Index root, std::vector<TreeNode>& nodes) {
  const Index n = w.rows();
  std::vector<Index> tree{root};
  nodes[static_cast<std::size_t>(root)] = {1, 0};
  Vector strongest = Vector::Constant(n, stands_out);
  std::vector<Index> by(static_cast<std::size_t>(n), -1);
  for (Index last = root; last >= 0;) {
    Index next = -1;
    double best = stands_out;
    for (Index j = 0; j < n; ++j) {
      if (nodes[static_cast<std::size_t>(j)].sign != 0) continue;
      const double link = strength(j, last);
      if (link > strongest(j)) {
        strongest(j) = link;
        by[static_cast<std::size_t>(j)] = last;
      }
      if (by[static_cast<std::size_t>(j)] >= 0 && strongest(j) > best) {
        best = strongest(j);
        next = j;
      }
    }
    if (next >= 0) {
      const Index from = by[static_cast<std::size_t>(next)];
      const TreeNode& parent = nodes[static_cast<std::size_t>(from)];
      nodes[static_cast<std::size_t>(next)] = {-parent.sign, 2 * std::arg(w(next, from)) - parent.offset};
      tree.push_back(next);
    }
    last = next;
  }
  return tree;
}

// arg d_i + arg d_j = 2 arg w_ij with equal signs: 2 sign φ = 2 arg w_ij − offsets.
double root_phase(const Matrix& strength, const ComplexMatrix& w, const std::vector<Index>& tree, const std::vector<TreeNode>& nodes) {
  double best = stands_out, phase = 0;
  for (const Index i : tree) {
    const TreeNode& a = nodes[static_cast<std::size_t>(i)];
    for (const Index j : tree) {
      const TreeNode& b = nodes[static_cast<std::size_t>(j)];
      if (a.sign != b.sign || !(strength(j, i) > best)) continue;
      best = strength(j, i);
      phase = a.sign * 0.5 * (2 * std::arg(w(j, i)) - a.offset - b.offset);
    }
  }
  return phase;
}

}  // namespace

ComplexVector phases_by_couplings(const ComplexMatrix& w, const Vector& noise) {
  const Index n = w.rows();
  Matrix strength = w.cwiseAbs();
  for (Index j = 0; j < n; ++j) strength.col(j).array() /= noise.array() + noise(j);
  std::vector<TreeNode> nodes(static_cast<std::size_t>(n));
  ComplexVector d(n);
  for (Index root = 0; root < n; ++root) {
    if (nodes[static_cast<std::size_t>(root)].sign != 0) continue;
    const std::vector<Index> tree = grow(strength, w, root, nodes);
    const double phase = root_phase(strength, w, tree, nodes);
    for (const Index i : tree) {
      const TreeNode& node = nodes[static_cast<std::size_t>(i)];
      d(i) = std::polar(1.0, node.sign * phase + node.offset);
    }
  }
  return d;
}

}  // namespace gyromode
