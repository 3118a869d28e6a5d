#include "gyromode/dense/general/indefinite.h"

#include "gyromode/dense/general/even_pencil.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/triangular.h"

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

namespace {

// X of w = (X, λX), units of 1/γ: the half that is large once the companion matrix is balanced, by √‖k‖, as LAPACK
// does; the other half has the absolute error of that one (Tisseur 2000).
ComplexVector shape_of(const ComplexVector& w, Complex lambda, double root_of_stiffness) {
  const Index n = w.size() / 2;
  return std::abs(lambda) > root_of_stiffness ? ComplexVector(w.tail(n) / lambda) : ComplexVector(w.head(n));
}

IndefiniteModes collected(const NormalForm& form, const std::vector<EvenRoot>& roots, double gamma) {
  const Index n = form.size();
  const double root_of_stiffness = std::sqrt(form.k.norm() / std::sqrt(static_cast<double>(std::max<Index>(n, 1)))) / gamma;
  IndefiniteModes modes;
  std::vector<const EvenRoot*> vibrations, unstable;
  for (const EvenRoot& r : roots) {
    if (r.lambda.real() != 0)
      unstable.push_back(&r);
    else if (r.lambda.imag() > 0)
      vibrations.push_back(&r);
  }
  modes.unstable = UnstableRoots(n, static_cast<Index>(unstable.size()));
  for (std::size_t k = 0; k < unstable.size(); ++k) {
    const EvenRoot& r = *unstable[k];
    modes.unstable.set(static_cast<Index>(k), r.lambda * gamma, shape_of(r.w, r.lambda, root_of_stiffness),
                       shape_of(r.left, -std::conj(r.lambda), root_of_stiffness));
  }
  std::sort(vibrations.begin(), vibrations.end(), [](const EvenRoot* a, const EvenRoot* b) { return a->lambda.imag() < b->lambda.imag(); });
  const Index m = static_cast<Index>(vibrations.size());
  modes.omega.resize(m);
  modes.shapes.resize(n, m);
  for (Index k = 0; k < m; ++k) {
    const EvenRoot& r = *vibrations[static_cast<std::size_t>(k)];
    modes.omega(k) = r.lambda.imag() * gamma;
    modes.shapes.col(k) = shape_of(r.w, r.lambda, root_of_stiffness);
  }
  return modes;
}

double time_scale(const NormalForm& form) {
  const double g = std::max(std::sqrt(form.k.norm()), form.gamma.norm());
  return g > 0 ? g : 1;
}

EvenPencil even_pencil(const NormalForm& form, double gamma) {
  return EvenPencil::of_second_order(form.gamma / gamma, form.k / (gamma * gamma));
}

}  // namespace

IndefiniteModes indefinite_modes(const NormalForm& form, const Matrix& gyroscopic_null) {
  const Index n = form.size();
  const double gamma = time_scale(form);
  const EvenPencil p = even_pencil(form, gamma);
  if (gyroscopic_null.cols() == 0) {
    const auto e = p.plain_eigen();
    return collected(form, roots_of(p, e.values, e.vectors), gamma);
  }
  // 𝓔(N_g, 0) = 0, so (N_g, 0)ᵀ𝒮w is constant, and zero in every motion with λ ≠ 0: those live in the complement of
  // 𝒮(N_g, 0).
  Matrix null = Matrix::Zero(2 * n, gyroscopic_null.cols());
  null.topRows(n) = gyroscopic_null;
  const Matrix v = lapack::orthogonal_completion(p.s_times(null)).rightCols(2 * n - null.cols());
  const EvenPencil regular = p.projected(v);
  const auto e = regular.plain_eigen();
  auto roots = roots_of(regular, e.values, e.vectors);
  for (EvenRoot& r : roots) {
    r.w = (v * r.w).eval();
    if (r.left.size() > 0) r.left = (v * r.left).eval();
  }
  return collected(form, roots, gamma);
}

IndefiniteModes resolve_roots(const NormalForm& form, const ComplexVector& lambda, const ComplexMatrix& z) {
  const Index n = form.size();
  const double gamma = time_scale(form);
  ComplexMatrix w(2 * n, z.cols());
  w.topRows(n) = z;
  w.bottomRows(n) = z * (lambda / gamma).asDiagonal();
  w.colwise().normalize();
  return collected(form, roots_of(even_pencil(form, gamma), lambda / gamma, w), gamma);
}

}  // namespace gyromode::dense
