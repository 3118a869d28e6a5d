#include "gyromode/dense/quadrature.h"

#include "gyromode/dense/product.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/singular.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"

#include <cmath>

namespace gyromode::dense {

namespace {

bool square(const Matrix& f) { return f.rows() == f.cols(); }

// x = f⁻ᵀ s where f is square; else x = (f s + b w)/ω², the same by the first row of (T5).
Matrix displacement(const QuadratureForm& form, const Matrix& s, const Matrix& w, const Vector& omega) {
  const Matrix& f = *form.f1;
  if (square(f)) {
    Matrix x = s;
    lapack::solve_lower_transposed(f, x);
    return x;
  }
  Matrix x = lapack::multiply(f, s) + lapack::multiply(form.b, w);
  return x * omega.cwiseAbs2().cwiseInverse().asDiagonal();
}

// From (s, w) of unit length, columns of v, to (x, y): theory below (T5).
QuadratureModes recovered(const QuadratureForm& form, const Vector& omega, const MatrixView& v) {
  const Index q = form.f1->cols();
  QuadratureModes modes;
  modes.omega = omega;
  const Matrix w = v.bottomRows(v.rows() - q);
  modes.x = displacement(form, v.topRows(q), w, omega);
  modes.y = w * omega.cwiseInverse().asDiagonal();
  return modes;
}

// W = [f b]ᵀ[f b] + diag(0, k₂).
Matrix w_matrix(const QuadratureForm& form) {
  const Matrix& f = *form.f1;
  const Index r = form.b.cols();
  Matrix fb(f.rows(), f.cols() + r);
  fb << f, form.b;
  Matrix w = lapack::gram(fb);
  w.bottomRightCorner(r, r) += form.k2;
  return w;
}

// An error ε‖W‖ in ω² is one of ε‖W‖/2ω in ω, while a backward error nε in K moves ω by nε‖K‖‖X‖²ω/2. The eigenvalues of W are good enough
// while the first is below the second for every mode, and while no ω² is below 1e-8 of the largest (there ω has 8 digits).
bool small_frequencies_ask_for_svd(const QuadratureForm& form, const QuadratureModes& modes, double norm_w) {
  if (modes.omega.size() == 0) return false;
  constexpr double smallest_ratio = 1e-4;
  if (modes.omega(0) < smallest_ratio * modes.omega(modes.omega.size() - 1)) return true;
  const double norm_k = std::max(form.k1.norm(), form.k2.norm());
  const double n = static_cast<double>(form.b.rows() + form.b.cols());
  for (Index i = 0; i < modes.omega.size(); ++i) {
    const double shape = modes.omega(i) * modes.omega(i) * (modes.x.col(i).squaredNorm() + modes.y.col(i).squaredNorm());
    if (!(norm_w <= n * norm_k * shape)) return true;
  }
  return false;
}

// C = [fᵀ 0; bᵀ f₂], W = C Cᵀ: frequencies to ε‖C‖, not √ε.
QuadratureModes by_singular_values(const QuadratureForm& form) {
  const Matrix& f1 = *form.f1;
  const Matrix& f2 = *form.f2;
  const Index q = f1.cols();
  Matrix c = Matrix::Zero(q + form.b.cols(), f1.rows() + f2.cols());
  c.topLeftCorner(q, f1.rows()) = f1.transpose();
  c.bottomLeftCorner(form.b.cols(), f1.rows()) = form.b.transpose();
  c.bottomRightCorner(form.b.cols(), f2.cols()) = f2;
  const auto svd = lapack::singular_value_decomposition(std::move(c));
  QuadratureModes modes = recovered(form, svd.values.reverse(), Matrix(svd.u.rowwise().reverse()));
  modes.path = "singular values of C (real, n × n), as small frequencies ask for";
  return modes;
}

QuadratureModes by_w(const QuadratureForm& form) {
  const Matrix w = w_matrix(form);
  const double norm_w = w.norm();
  const auto e = lapack::symmetric_eigen(w);
  const Index unstable = (e.values.array() < 0).count();
  const Index m = e.values.size() - unstable;
  QuadratureModes modes = recovered(form, e.values.tail(m).cwiseSqrt(), e.vectors.rightCols(m));
  if (form.f2 && (unstable > 0 || small_frequencies_ask_for_svd(form, modes, norm_w))) return by_singular_values(form);
  for (Index i = 0; i < unstable; ++i) modes.divergence.push_back(std::sqrt(-e.values(i)));
  modes.path = "eigenvalues of W (real symmetric, n × n)";
  return modes;
}

// The groups exchanged: x ↔ y, b → −bᵀ. A motion (x, −jy) of the exchanged form is, times j, the motion (y, jx) → (y, −j(−x)) of this one.
QuadratureForm exchanged(const QuadratureForm& form) { return {-form.b.transpose(), form.k2, form.k1, form.f2, form.f1, form.null2, form.null1}; }

QuadratureModes exchanged_back(QuadratureModes modes) {
  std::swap(modes.x, modes.y);
  modes.y = -modes.y;
  return modes;  // a block ≥ 0 cannot flutter: no shapes of that kind to exchange
}

}  // namespace

QuadratureModes quadrature_modes(const QuadratureForm& form) {
  if (form.f1) return by_w(form);
  if (form.f2) return exchanged_back(by_w(exchanged(form)));
  return product_modes(form);
}

}  // namespace gyromode::dense
