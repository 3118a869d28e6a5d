#include "gyromode/sparse/groups.h"

#include "gyromode/sparse/node_order.h"

namespace gyromode::sparse {

Groups groups_of(const Structure& structure, Index n) {
  Groups g;
  g.partition = structure.system_class() == SystemClass::quadrature;
  g.across.assign(static_cast<std::size_t>(n), false);
  if (g.partition) {
    for (const Index i : structure.in_quadrature()) g.across[static_cast<std::size_t>(i)] = true;
  }
  for (Index i = 0; i < n; ++i) g.rows[g.across[static_cast<std::size_t>(i)] ? 1 : 0].push_back(i);
  return g;
}

std::vector<int> elimination_order(const SparseSystem& system, const std::vector<Index>& rows) {
  std::vector<int> node;
  for (const Index i : rows) node.push_back(system.node()[static_cast<std::size_t>(i)]);
  return coordinate_order(system.places(), node);
}

SparseMatrix coupling_of(const SparseSystem& system, const Groups& groups) {
  SparseMatrix c = system.gyroscopic();
  for (Index j = 0; j < c.outerSize(); ++j) {
    for (auto e = c.outerIndexPtr()[j]; e < c.outerIndexPtr()[j + 1]; ++e) {
      if (groups.across[static_cast<std::size_t>(c.innerIndexPtr()[e])]) c.valuePtr()[e] *= -1;
    }
  }
  return c;
}

}  // namespace gyromode::sparse
