#include "gyromode/sparse/resting.h"

#include "gyromode/sparse/factor.h"
#include "gyromode/sparse/node_order.h"

namespace gyromode::sparse {

Index negative_at_rest(const SparseSystem& s, const Groups& groups, double mu) {
  Index negative = 0;
  for (const std::vector<Index>& rows : groups.rows) {
    if (rows.empty()) continue;
    const SparseMatrix a = restricted(s.stiffness(), rows) - mu * restricted(s.mass(), rows);
    std::vector<int> node;
    for (const Index i : rows) node.push_back(s.node()[static_cast<std::size_t>(i)]);
    SymmetricFactor factor(a, coordinate_order(s.places(), node), SymmetricFactor::Keep::counts);
    negative += factor.factor(a);
  }
  return negative;
}

}  // namespace gyromode::sparse
