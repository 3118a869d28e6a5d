#include "gyromode/dense/quadrature/product.h"

#include "gyromode/dense/quadrature/product_problem.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/triangular.h"

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

namespace {

QuadratureModes collected(const QuadratureForm& form, const std::vector<ProductRoot>& roots) {
  const Index p = form.first.k().rows();
  const Index r = form.second.k().rows();
  QuadratureModes modes;
  std::vector<const ProductRoot*> vibrations, unstable;
  for (const ProductRoot& root : roots) {
    if (root.mu.imag() == 0 && root.mu.real() > 0)
      vibrations.push_back(&root);
    else if (root.mu.imag() >= 0)
      unstable.push_back(&root);
  }
  modes.unstable = UnstableRoots(p + r, static_cast<Index>(unstable.size()));
  for (std::size_t k = 0; k < unstable.size(); ++k) {
    // λ² = −μ and −μ̄: one pair or quadruple. Its λ = σ + jω with σ > 0, ω ≥ 0 has λ² = −μ̄, so the vector ū.
    const ProductRoot& root = *unstable[k];
    const Complex frequency = std::sqrt(root.mu);  // ω + jσ
    const Complex lambda(frequency.imag(), frequency.real());
    ComplexVector shape = root.u.conjugate();  // (x, ẏ), ẏ = λy
    shape.tail(r) /= lambda;
    modes.unstable.set(static_cast<Index>(k), lambda, shape, reversed(shape, p));
  }
  std::sort(vibrations.begin(), vibrations.end(), [](const ProductRoot* a, const ProductRoot* b) { return a->mu.real() < b->mu.real(); });
  const Index m = static_cast<Index>(vibrations.size());
  modes.omega.resize(m);
  modes.x.resize(p, m);
  modes.y.resize(r, m);
  for (Index i = 0; i < m; ++i) {
    const ProductRoot& root = *vibrations[static_cast<std::size_t>(i)];
    modes.omega(i) = std::sqrt(root.mu.real());
    modes.x.col(i) = root.u.head(p).real();
    modes.y.col(i) = root.u.tail(r).real() / modes.omega(i);
  }
  modes.solver = "eigenvalues of P (real, n × n), both stiffness blocks indefinite";
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

// K singular with N₁ᵀbN₂ regular: n_u = (N₁, 0) and n_v = (0, N₂) have E_u n_u = 0, E_v n_v = 0, so n_vᵀΣᵀu and n_uᵀΣv
// are constant, and zero in every motion with λ ≠ 0. Those motions live in the complements of Σ n_v and Σᵀ n_u.
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
  if (form.first.null().cols() == 0) return collected(form, roots_of(product, p_matrix(form)));
  const Regular regular = without_zero_roots(product, form);
  auto roots = roots_of(regular.product, product_matrix(regular.product));
  for (ProductRoot& r : roots) r.u = (regular.u * r.u).eval();
  return collected(form, roots);
}

// u = (x, ẏ) mixes displacements with rates: their weight is right where time is counted in units of 1/γ.
double time_scale(const QuadratureForm& form) {
  const double gamma = std::max(std::sqrt(std::max(form.first.k().norm(), form.second.k().norm())), form.b.norm());
  return gamma > 0 ? std::exp2(std::round(std::log2(gamma))) : 1;
}

QuadratureModes in_units_of(double gamma, QuadratureModes modes) {
  modes.omega *= gamma;
  for (Complex& lambda : modes.unstable.lambda) lambda *= gamma;
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
