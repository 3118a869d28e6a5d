#include "gyromode/sparse/isotropy.h"

#include "gyromode/base/rounding.h"

#include <algorithm>
#include <cmath>

namespace gyromode::sparse {

namespace {

constexpr double rounding = 8 * epsilon;  // relative, of an entry

bool near(double a, double b) { return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b)); }

// Every coordinate with the one that G couples it to most, M's diagonal entries being 1. As |M_ij| < 1 then beside the
// diagonal, that is the one across from it where G = 2ΩJM.
std::vector<Index> partners(const SparseSystem& s) {
  const auto n = static_cast<std::size_t>(s.size());
  const Vector size = s.mass().diagonal().cwiseSqrt();
  std::vector<Index> partner(n, -1);
  std::vector<double> most(n, 0);
  for (Index j = 0; j < s.size(); ++j) {
    for (SparseMatrix::InnerIterator it(s.gyroscopic(), j); it; ++it) {
      const double g = std::abs(it.value()) / (size(it.row()) * size(j));
      for (const auto& [one, other] : {std::pair(it.row(), j), std::pair(j, it.row())}) {
        const auto at = static_cast<std::size_t>(one);
        if (g > most[at]) {
          most[at] = g;
          partner[at] = other;
        }
      }
    }
  }
  return partner;
}

// Which coordinates are x, which are y, and the place of each among its kind.
struct Pairs {
  std::vector<Index> x, y, place;
  std::vector<bool> is_x;
};

std::optional<Pairs> pairs_of(const SparseSystem& s) {
  const Index n = s.size();
  const std::vector<Index> partner = partners(s);
  Pairs p;
  p.place.assign(static_cast<std::size_t>(n), -1);
  p.is_x.assign(static_cast<std::size_t>(n), false);
  for (Index j = 0; j < n; ++j) {
    const Index i = partner[static_cast<std::size_t>(j)];
    if (i < 0 || partner[static_cast<std::size_t>(i)] != j) return std::nullopt;
    if (i < j) continue;
    const double g = s.gyroscopic().coeff(i, j);  // G_yx is positive
    const Index x = g > 0 ? j : i, y = g > 0 ? i : j;
    p.place[static_cast<std::size_t>(x)] = p.place[static_cast<std::size_t>(y)] = static_cast<Index>(p.x.size());
    p.is_x[static_cast<std::size_t>(x)] = true;
    p.x.push_back(x);
    p.y.push_back(y);
  }
  return p;
}

// The block that a and its copy share, where a is 1₂ ⊗ that block to rounding.
std::optional<SparseMatrix> block_twice(const SparseMatrix& a, const Pairs& p) {
  const auto half = static_cast<Index>(p.x.size());
  std::vector<Eigen::Triplet<double>> entries[2];
  for (Index j = 0; j < a.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(a, j); it; ++it) {
      if (it.value() == 0) continue;
      const auto r = static_cast<std::size_t>(it.row()), c = static_cast<std::size_t>(j);
      if (p.is_x[r] != p.is_x[c]) return std::nullopt;
      const Index k = p.place[r], l = p.place[c];
      entries[p.is_x[r] ? 0 : 1].emplace_back(static_cast<int>(std::max(k, l)), static_cast<int>(std::min(k, l)), it.value());
    }
  }
  if (entries[0].size() != entries[1].size()) return std::nullopt;
  SparseMatrix block[2] = {SparseMatrix(half, half), SparseMatrix(half, half)};
  for (int d = 0; d < 2; ++d) block[d].setFromTriplets(entries[d].begin(), entries[d].end());
  for (Index j = 0; j < half; ++j) {
    SparseMatrix::InnerIterator one(block[0], j), two(block[1], j);
    for (; one && two; ++one, ++two) {
      if (one.row() != two.row() || !near(one.value(), two.value())) return std::nullopt;
    }
    if (one || two) return std::nullopt;
  }
  return std::move(block[0]);
}

// Whether G_yx is 2ΩM₀, entry by entry.
bool is_turning(const SparseMatrix& g, const Pairs& p, const SparseMatrix& mass, double spin) {
  Index seen = 0;
  for (Index j = 0; j < g.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(g, j); it; ++it) {
      if (it.value() == 0) continue;
      const auto r = static_cast<std::size_t>(it.row()), c = static_cast<std::size_t>(j);
      if (p.is_x[r] == p.is_x[c]) return false;
      const Index k = p.place[r], l = p.place[c];
      const double value = p.is_x[c] ? it.value() : -it.value();
      if (!near(value, 2 * spin * mass.coeff(std::max(k, l), std::min(k, l)))) return false;
      ++seen;
    }
  }
  return seen == 2 * mass.nonZeros() - mass.cols();  // every entry beside the diagonal once above and once below
}

}  // namespace

std::optional<Isotropy> isotropy_of(const SparseSystem& s) {
  if (s.gyroscopic().nonZeros() == 0 || s.size() % 2 != 0 || s.singular_mass() || s.translations().cols() > 0) return std::nullopt;
  std::optional<Pairs> p = pairs_of(s);
  if (!p) return std::nullopt;
  std::optional<SparseMatrix> stiffness = block_twice(s.stiffness(), *p);
  if (!stiffness) return std::nullopt;
  std::optional<SparseMatrix> mass = block_twice(s.mass(), *p);
  if (!mass) return std::nullopt;
  Isotropy i;
  const Index x = p->x.front(), y = p->y.front();
  i.spin = std::abs(s.gyroscopic().coeff(std::max(x, y), std::min(x, y))) / (2 * mass->coeff(0, 0));
  if (!is_turning(s.gyroscopic(), *p, *mass, i.spin)) return std::nullopt;
  i.stiffness = *stiffness + (i.spin * i.spin) * *mass;
  i.mass = *mass;
  i.x = std::move(p->x);
  i.y = std::move(p->y);
  return i;
}

}  // namespace gyromode::sparse
