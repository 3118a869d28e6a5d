#include "gyromode/dense/quadrature/product_problem.h"

#include "gyromode/dense/basis.h"
#include "gyromode/dense/pencil.h"
#include "gyromode/lapack/general.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/small.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode::dense {

namespace {

// Σ⁻¹ E_u u = −v̇ for every column.
Matrix velocity(const Product& p, const Matrix& u) { return lapack::multiply(p.sigma_inverse, lapack::multiply(p.eu, u)); }

// Groups of positions whose roots are within `gap` of a neighbour in the order of their real parts, conjugate pairs
// kept together.
std::vector<std::vector<Index>> close_groups(const ComplexVector& mu, double gap) {
  std::vector<Index> order(static_cast<std::size_t>(mu.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return mu(a).real() < mu(b).real(); });
  std::vector<std::vector<Index>> groups;
  for (const Index i : order) {
    const bool near = !groups.empty() && std::abs(mu(i) - mu(groups.back().back())) <= gap;
    const bool conjugate = !groups.empty() && mu(i).imag() != 0 && mu(i) == std::conj(mu(groups.back().back()));
    if (near || conjugate) {
      groups.back().push_back(i);
    } else {
      groups.push_back({i});
    }
  }
  return groups;
}

// A complex pair far from the real axis, and from every other root.
bool isolated_pair(const ComplexVector& mu, const std::vector<Index>& group, double gap) {
  return group.size() == 2 && mu(group[0]) == std::conj(mu(group[1])) && std::abs(mu(group[0]).imag()) > gap;
}

bool resolve_group(const Product& p, const Matrix& basis, std::vector<ProductRoot>& roots) {
  const Matrix eu = lapack::multiply_tn(basis, lapack::multiply(p.eu, basis));
  const Matrix v = velocity(p, basis);
  const Matrix a = lapack::multiply_tn(v, lapack::multiply(p.ev, v));
  const auto found = self_adjoint_pencil(a.cast<Complex>(), eu.cast<Complex>());
  for (const PencilRoot& r : found) {
    ComplexVector u = basis * r.y;
    if (r.value.imag() == 0) {  // a real vector of the real pencil, up to a phase
      Index largest = 0;
      u.cwiseAbs().maxCoeff(&largest);
      u = (u * std::conj(u(largest)) / std::abs(u(largest))).real().cast<Complex>();
      u.normalize();
    }
    roots.push_back({r.value, u});
  }
  return !found.empty();
}

// One level: `p` is `whole` in the bases `u` and `v` of its halves (`whole` itself where they are empty). Roots far
// below the largest are solved again by themselves, in orthonormal bases U and V = Σ⁻¹E_u U of their halves, in which
// the whole problem is projected, not this one: what is small in it keeps its digits.
std::vector<ProductRoot> roots_of(const Product& whole, const Product& p, const Matrix& u, const Matrix& product, int depth) {
  constexpr double small_ratio = 1e-4;  // in μ = ω²
  constexpr double close_ratio = 1e-9;
  constexpr int deepest = 12;
  const auto e = lapack::general_eigen(product);
  const double largest = e.values.cwiseAbs().maxCoeff();
  std::vector<ProductRoot> roots;
  std::vector<Index> small;
  for (const auto& group : close_groups(e.values, close_ratio * largest)) {
    const bool is_small =
        depth < deepest && std::all_of(group.begin(), group.end(), [&](Index i) { return std::abs(e.values(i)) <= small_ratio * largest; });
    if (is_small) {
      small.insert(small.end(), group.begin(), group.end());
    } else if (group.size() == 1 || isolated_pair(e.values, group, close_ratio * largest)) {
      for (const Index i : group) roots.push_back({e.values(i), e.vectors.col(i)});
    } else if (!resolve_group(p, real_basis(e.vectors, e.values, group), roots)) {
      for (const Index i : group) roots.push_back({e.values(i), e.vectors.col(i)});  // defective: the plain roots
    }
  }
  if (u.size() > 0) {
    for (ProductRoot& r : roots) r.u = (u * r.u).eval();
  }
  if (small.empty()) return roots;
  const Matrix part = real_basis(e.vectors, e.values, small);
  const Matrix inner_u = u.size() > 0 ? orthonormal_basis(lapack::multiply(u, part)) : part;
  const Product inner = projected(whole, inner_u, orthonormal_basis(velocity(whole, inner_u)));
  for (ProductRoot& r : roots_of(whole, inner, inner_u, product_matrix(inner), depth + 1)) roots.push_back(std::move(r));
  return roots;
}

}  // namespace

Matrix product_matrix(const Product& p) {
  return lapack::multiply_tn(p.sigma_inverse, lapack::multiply(p.ev, lapack::multiply(p.sigma_inverse, p.eu)));
}

Product projected(const Product& p, const Matrix& u, const Matrix& v) {
  const auto onto = [](const Matrix& left, const Matrix& a, const Matrix& right) {
    return lapack::multiply_tn(left, lapack::multiply(a, right));
  };
  Product small{onto(u, p.sigma, v), {}, onto(u, p.eu, u), onto(v, p.ev, v)};
  small.sigma_inverse = small::inverse(small.sigma);
  return small;
}

std::vector<ProductRoot> roots_of(const Product& p, const Matrix& product) { return roots_of(p, p, Matrix(), product, 0); }

}  // namespace gyromode::dense
