#include "gyromode/dense/indefinite.h"

#include "gyromode/dense/even_pencil.h"
#include "gyromode/lapack/general.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/triangular.h"

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

namespace {

IndefiniteModes collected(Index n, const std::vector<EvenRoot>& roots, double gamma) {
  IndefiniteModes modes;
  std::vector<const EvenRoot*> vibrations;
  for (const EvenRoot& r : roots) {
    if (r.lambda.real() == 0) {
      if (r.lambda.imag() > 0) vibrations.push_back(&r);
    } else if (r.lambda.imag() == 0) {
      modes.divergence.push_back(r.lambda.real() * gamma);
    } else {
      modes.flutter.push_back(r.lambda * gamma);
      modes.flutter_shapes.conservativeResize(n, modes.flutter_shapes.cols() + 1);
      modes.flutter_shapes.rightCols(1) = r.w.head(n);
    }
  }
  std::sort(vibrations.begin(), vibrations.end(), [](const EvenRoot* a, const EvenRoot* b) { return a->lambda.imag() < b->lambda.imag(); });
  const Index m = static_cast<Index>(vibrations.size());
  modes.omega.resize(m);
  modes.shapes.resize(n, m);
  for (Index k = 0; k < m; ++k) {
    const EvenRoot& r = *vibrations[static_cast<std::size_t>(k)];
    modes.omega(k) = r.lambda.imag() * gamma;
    modes.shapes.col(k) = r.w.head(n);
  }
  return modes;
}

double time_scale(const NormalForm& form) {
  const double g = std::max(std::sqrt(form.k.norm()), form.gamma.norm());
  return g > 0 ? g : 1;
}

EvenPencil even_pencil(const NormalForm& form, double gamma) {
  const Index n = form.size();
  EvenPencil p{Matrix::Zero(2 * n, 2 * n), Matrix::Zero(2 * n, 2 * n)};
  p.s.topLeftCorner(n, n) = form.gamma / gamma;
  p.s.topRightCorner(n, n).setIdentity();
  p.s.bottomLeftCorner(n, n) = -Matrix::Identity(n, n);
  // time in units of 1/γ: 𝓔/γ
  p.e.topLeftCorner(n, n) = form.k / (gamma * gamma);
  p.e.bottomRightCorner(n, n).setIdentity();
  return p;
}

// [0 1; −k −Γ] in units of γ.
Matrix companion(const NormalForm& form, double gamma) {
  const Index n = form.size();
  Matrix a = Matrix::Zero(2 * n, 2 * n);
  a.topRightCorner(n, n).setIdentity();
  a.bottomLeftCorner(n, n) = -form.k / (gamma * gamma);
  a.bottomRightCorner(n, n) = -form.gamma / gamma;
  return a;
}

}  // namespace

IndefiniteModes indefinite_modes(const NormalForm& form, const Matrix& gyroscopic_null) {
  const Index n = form.size();
  const double gamma = time_scale(form);
  const EvenPencil p = even_pencil(form, gamma);
  if (gyroscopic_null.cols() == 0) {
    const auto e = lapack::general_eigen(companion(form, gamma));
    return collected(n, roots_of(p, e.values, e.vectors), gamma);
  }
  // 𝓔(N_g, 0) = 0, so (N_g, 0)ᵀ𝒮w is constant, and zero in every motion with λ ≠ 0: those live in the complement of 𝒮(N_g, 0).
  Matrix null = Matrix::Zero(2 * n, gyroscopic_null.cols());
  null.topRows(n) = gyroscopic_null;
  const Matrix v = lapack::orthogonal_completion(lapack::multiply(p.s, null)).rightCols(2 * n - null.cols());
  const EvenPencil regular = projected(p, v);
  const auto e = plain_eigen(regular);
  auto roots = roots_of(regular, e.values, e.vectors);
  for (EvenRoot& r : roots) r.w = (v * r.w).eval();
  return collected(n, roots, gamma);
}

IndefiniteModes resolve_roots(const NormalForm& form, const ComplexVector& lambda, const ComplexMatrix& z) {
  const Index n = form.size();
  const double gamma = time_scale(form);
  ComplexMatrix w(2 * n, z.cols());
  w.topRows(n) = z;
  w.bottomRows(n) = z * (lambda / gamma).asDiagonal();
  w.colwise().normalize();
  return collected(n, roots_of(even_pencil(form, gamma), lambda / gamma, w), gamma);
}

}  // namespace gyromode::dense
