#include "gyromode/sparse/components.h"

#include <numeric>

namespace gyromode::sparse {

// Union-find: the root of a set is its first coordinate.
std::vector<std::vector<Index>> components_of(const SparseMatrix& lower) {
  std::vector<Index> parent(static_cast<std::size_t>(lower.cols()));
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto of = [&](Index i) -> Index& { return parent[static_cast<std::size_t>(i)]; };
  const auto root = [&](Index i) {
    while (of(i) != i) i = of(i) = of(of(i));
    return i;
  };
  for (Index j = 0; j < lower.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
      if (it.value() == 0) continue;
      const Index a = root(it.row()), b = root(j);
      of(std::max(a, b)) = std::min(a, b);
    }
  }
  std::vector<std::vector<Index>> all;
  std::vector<std::size_t> which(parent.size());
  for (Index i = 0; i < lower.cols(); ++i) {
    const Index first = root(i);
    if (first == i) {
      which[static_cast<std::size_t>(i)] = all.size();
      all.emplace_back();
    }
    all[which[static_cast<std::size_t>(first)]].push_back(i);
  }
  return all;
}

}  // namespace gyromode::sparse
