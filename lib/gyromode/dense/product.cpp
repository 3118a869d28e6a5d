#include "gyromode/dense/product.h"

#include "gyromode/dense/basis.h"
#include "gyromode/dense/pencil.h"
#include "gyromode/lapack/general.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/triangular.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode::dense {

namespace {

// One first-order problem Σ v̇ = −E_u u, Σᵀ u̇ = E_v v.
struct Product {
  Matrix sigma, sigma_inverse, eu, ev;
};

// One root μ = ω² with its unit vector u, which is real (imaginary part zero) for real μ.
struct Root {
  Complex mu;
  ComplexVector u;
};

// Σ⁻¹ E_u u = −v̇ for every column.
Matrix velocity(const Product& p, const Matrix& u) { return lapack::multiply(p.sigma_inverse, lapack::multiply(p.eu, u)); }

Matrix product_matrix(const Product& p) {
  return lapack::multiply_tn(p.sigma_inverse, lapack::multiply(p.ev, lapack::multiply(p.sigma_inverse, p.eu)));
}

// The problem in bases U and V of invariant subspaces of its two halves, orthonormal columns.
Product projected(const Product& p, const Matrix& u, const Matrix& v) {
  const auto onto = [](const Matrix& left, const Matrix& a, const Matrix& right) { return lapack::multiply_tn(left, lapack::multiply(a, right)); };
  Product small{onto(u, p.sigma, v), {}, onto(u, p.eu, u), onto(v, p.ev, v)};
  small.sigma_inverse = small.sigma.inverse();
  return small;
}

// Groups of positions whose roots are within `gap` of a neighbour in the order of their real parts, conjugate pairs kept together.
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

bool resolve_group(const Product& p, const Matrix& basis, std::vector<Root>& roots) {
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

std::vector<Root> roots_of(const Product& p, const Matrix& product, int depth);

// The roots of the small group, solved by themselves in orthonormal bases U and V = Σ⁻¹E_u U of its two halves.
void resolve_small(const Product& p, const Matrix& u, std::vector<Root>& roots, int depth) {
  const Matrix v = orthonormal_basis(velocity(p, u));
  const Product small = projected(p, u, v);
  for (Root& r : roots_of(small, product_matrix(small), depth + 1)) roots.push_back({r.mu, u * r.u});
}

std::vector<Root> roots_of(const Product& p, const Matrix& product, int depth) {
  constexpr double small_ratio = 1e-4;  // in μ = ω²
  constexpr double close_ratio = 1e-9;
  constexpr int deepest = 12;
  const auto e = lapack::general_eigen(product);
  const double largest = e.values.cwiseAbs().maxCoeff();
  std::vector<Root> roots;
  std::vector<Index> small;
  for (const auto& group : close_groups(e.values, close_ratio * largest)) {
    const bool is_small = depth < deepest && std::all_of(group.begin(), group.end(), [&](Index i) { return std::abs(e.values(i)) <= small_ratio * largest; });
    if (is_small) {
      small.insert(small.end(), group.begin(), group.end());
    } else if (group.size() == 1 || isolated_pair(e.values, group, close_ratio * largest)) {
      for (const Index i : group) roots.push_back({e.values(i), e.vectors.col(i)});
    } else if (!resolve_group(p, real_basis(e.vectors, e.values, group), roots)) {
      for (const Index i : group) roots.push_back({e.values(i), e.vectors.col(i)});  // defective: the plain roots
    }
  }
  if (!small.empty()) resolve_small(p, real_basis(e.vectors, e.values, small), roots, depth);
  return roots;
}

QuadratureModes collected(const QuadratureForm& form, std::vector<Root> roots) {
  const Index p = form.first.k().rows();
  const Index r = form.second.k().rows();
  QuadratureModes modes;
  std::vector<const Root*> vibrations;
  for (const Root& root : roots) {
    if (root.mu.imag() == 0 && root.mu.real() > 0) vibrations.push_back(&root);
    if (root.mu.imag() == 0 && root.mu.real() < 0) modes.divergence.push_back(std::sqrt(-root.mu.real()));
    if (root.mu.imag() > 0) {  // λ² = −μ and −μ̄: one quadruple. Its λ = σ + jω with σ, ω > 0 has λ² = −μ̄, so the vector ū
      const Complex frequency = std::sqrt(root.mu);  // ω + jσ
      const Complex lambda(frequency.imag(), frequency.real());
      modes.flutter.push_back(lambda);
      ComplexVector shape = root.u.conjugate();  // (x, ẏ), ẏ = λy
      shape.tail(r) /= lambda;
      modes.flutter_shapes.conservativeResize(p + r, modes.flutter_shapes.cols() + 1);
      modes.flutter_shapes.rightCols(1) = shape;
    }
  }
  std::sort(vibrations.begin(), vibrations.end(), [](const Root* a, const Root* b) { return a->mu.real() < b->mu.real(); });
  const Index m = static_cast<Index>(vibrations.size());
  modes.omega.resize(m);
  modes.x.resize(p, m);
  modes.y.resize(r, m);
  for (Index i = 0; i < m; ++i) {
    const Root& root = *vibrations[static_cast<std::size_t>(i)];
    modes.omega(i) = std::sqrt(root.mu.real());
    modes.x.col(i) = root.u.head(p).real();
    modes.y.col(i) = root.u.tail(r).real() / modes.omega(i);
  }
  modes.path = "eigenvalues of P (real, n × n), both stiffness blocks indefinite";
  return modes;
}

Product product_of(const QuadratureForm& form) {
  const Index p = form.first.k().rows();
  const Index r = form.second.k().rows();
  Product product;
  product.sigma = Matrix::Identity(p + r, p + r);
  product.sigma.topRightCorner(p, r) = form.b;
  product.sigma.bottomRightCorner(r, r) *= -1;
  product.sigma_inverse = product.sigma;
  product.eu = Matrix::Identity(p + r, p + r);
  product.eu.topLeftCorner(p, p) = form.first.k();
  product.ev = Matrix::Identity(p + r, p + r);
  product.ev.bottomRightCorner(r, r) = form.second.k();
  return product;
}

// P of (T6), cheaper by its blocks.
Matrix p_matrix(const QuadratureForm& form) {
  const Index p = form.first.k().rows();
  const Index r = form.second.k().rows();
  Matrix m(p + r, p + r);
  m.topLeftCorner(p, p) = form.first.k();
  m.topRightCorner(p, r) = form.b;
  m.bottomLeftCorner(r, p) = lapack::multiply_tn(form.b, form.first.k());
  m.bottomRightCorner(r, r) = lapack::gram(form.b) + form.second.k();
  return m;
}

// K singular with N₁ᵀbN₂ regular: n_u = (N₁, 0) and n_v = (0, N₂) have E_u n_u = 0, E_v n_v = 0, so n_vᵀΣᵀu and n_uᵀΣv are constant, and zero in every
// motion with λ ≠ 0. Those motions live in the complements of Σ n_v and Σᵀ n_u.
struct Regular {
  Product product;
  Matrix u;
};

Regular without_zero_roots(const Product& p, const QuadratureForm& form) {
  const Index n = p.sigma.rows();
  const Index s = form.first.null().cols();
  Matrix nu = Matrix::Zero(n, s);
  Matrix nv = Matrix::Zero(n, s);
  nu.topRows(form.first.k().rows()) = form.first.null();
  nv.bottomRows(form.second.k().rows()) = form.second.null();
  Matrix u = lapack::orthogonal_completion(lapack::multiply(p.sigma, nv)).rightCols(n - s);
  const Matrix v = lapack::orthogonal_completion(lapack::multiply_tn(p.sigma, nu)).rightCols(n - s);
  return {projected(p, u, v), std::move(u)};
}

QuadratureModes solved(const QuadratureForm& form) {
  const Product product = product_of(form);
  if (form.first.null().cols() == 0) return collected(form, roots_of(product, p_matrix(form), 0));
  const Regular regular = without_zero_roots(product, form);
  auto roots = roots_of(regular.product, product_matrix(regular.product), 0);
  for (Root& r : roots) r.u = (regular.u * r.u).eval();
  return collected(form, std::move(roots));
}

// u = (x, ẏ) mixes displacements with rates: their weight is right where time is counted in units of 1/γ.
double time_scale(const QuadratureForm& form) {
  const double gamma = std::max(std::sqrt(std::max(form.first.k().norm(), form.second.k().norm())), form.b.norm());
  return gamma > 0 ? std::exp2(std::round(std::log2(gamma))) : 1;
}

QuadratureModes in_units_of(double gamma, QuadratureModes modes) {
  modes.omega *= gamma;
  for (double& sigma : modes.divergence) sigma *= gamma;
  for (Complex& lambda : modes.flutter) lambda *= gamma;
  return modes;
}

}  // namespace

QuadratureModes product_modes(const QuadratureForm& physical) {
  const double gamma = time_scale(physical);
  const auto scaled = [&](const StiffnessBlock& given) {
    StiffnessBlock block(given.k() / (gamma * gamma));
    block.set_null(given.null());
    return block;
  };
  const QuadratureForm form{physical.b / gamma, scaled(physical.first), scaled(physical.second)};
  return in_units_of(gamma, solved(form));
}

}  // namespace gyromode::dense
