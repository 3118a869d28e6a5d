#include "gyromode/sparse/mass_law.h"

#include "gyromode/base/error.h"
#include "gyromode/sparse/components.h"
#include "gyromode/sparse/factor.h"
#include "gyromode/sparse/node_order.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode::sparse {

namespace {

bool equal(const SparseMatrix& a, const SparseMatrix& b) {
  return a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr()) &&
         std::equal(a.valuePtr(), a.valuePtr() + a.nonZeros(), b.valuePtr());
}

// How many eigenvalues are negative beyond rounding, and whether any is not positive beyond it.
struct Law {
  Index negative = 0;
  bool singular = false;
};

Law law_of(const SparseMatrix& mass, const std::vector<int>& order) {
  constexpr double rounding = 1e-12;
  const Vector diagonal = mass.diagonal();
  SymmetricFactor factor(mass, order, SymmetricFactor::Keep::counts);
  SparseMatrix shifted = mass;
  for (Index j = 0; j < mass.cols(); ++j) shifted.coeffRef(j, j) -= rounding * diagonal(j);
  if (factor.factor(shifted) == 0) return {};
  for (Index j = 0; j < mass.cols(); ++j) shifted.coeffRef(j, j) += 2 * rounding * diagonal(j);
  return {factor.factor(shifted), true};
}

}  // namespace

// Meshes have the same mass along every direction, apart from one another: equal blocks are looked at once.
bool is_singular_mass(const SparseMatrix& mass, const std::vector<int>& places, const std::vector<int>& node, const Labels& labels) {
  constexpr std::size_t few = 16;
  const Vector diagonal = mass.diagonal();
  for (Index j = 0; j < mass.cols(); ++j) {
    if (!(diagonal(j) > 0))
      throw LawBroken(
          fmt::format("M must be positive definite: its diagonal entry of {} is {:.6g}", labels[static_cast<std::size_t>(j)], diagonal(j)));
  }
  const std::vector<std::vector<Index>> parts = components_of(mass);
  Law all;
  if (parts.size() == 1 || parts.size() > few) {
    all = law_of(mass, coordinate_order(places, node));
  } else {
    std::vector<std::pair<SparseMatrix, Law>> known;
    for (const std::vector<Index>& rows : parts) {
      SparseMatrix block = restricted(mass, rows);
      auto same = std::find_if(known.begin(), known.end(), [&](const auto& k) { return equal(k.first, block); });
      if (same == known.end()) {
        std::vector<int> nodes;
        for (const Index i : rows) nodes.push_back(node[static_cast<std::size_t>(i)]);
        const Law law = law_of(block, coordinate_order(places, nodes));
        same = known.emplace(known.end(), std::move(block), law);
      }
      all.negative += same->second.negative;
      all.singular = all.singular || same->second.singular;
    }
  }
  if (all.negative > 0)
    throw LawBroken(fmt::format("M must not be indefinite: {} of its eigenvalues are negative beyond rounding", all.negative));
  return all.singular;
}

}  // namespace gyromode::sparse
