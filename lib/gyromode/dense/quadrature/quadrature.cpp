#include "gyromode/dense/quadrature/quadrature.h"

#include "gyromode/dense/quadrature/product.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/singular.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/lapack/tridiagonal.h"

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

namespace {

// The shapes asked for of x = f⁻ᵀ s where f is square; else of x = (f s + b w)/ω², the same by the first row of (T5).
Matrix displacement(const QuadratureForm& form, const MatrixView& s, const MatrixView& w, const Vector& omega) {
  const Matrix& f = form.first.root();
  if (f.rows() == f.cols()) {
    Matrix x = s;
    form.first.shapes_of_root(x);
    return x;
  }
  Matrix x = lapack::multiply(f, s);
  lapack::multiply_into(x, 1, form.b, false, w, false, 1);
  x *= omega.cwiseAbs2().cwiseInverse().asDiagonal();
  form.first.shapes(x);
  return x;
}

// From (s, w) of unit length, columns of v, to (x, y): theory below (T5).
QuadratureModes recovered(const QuadratureForm& form, const Vector& omega, const MatrixView& v) {
  const Index q = form.first.root().cols();
  const MatrixView w = v.bottomRows(v.rows() - q);
  Matrix y = w * omega.cwiseInverse().asDiagonal();
  form.second.shapes(y);
  return {omega, displacement(form, v.topRows(q), w, omega), std::move(y), {}, {}};
}

// Columns (x, y) of the form, to the shapes asked for.
void shapes_of(const QuadratureForm& form, ComplexMatrix& z) {
  if (z.cols() == 0) return;
  Matrix re = z.real(), im = z.imag();
  for (Matrix* part : {&re, &im}) {
    form.first.shapes(part->topRows(form.first.size()));
    form.second.shapes(part->bottomRows(form.second.size()));
  }
  z.real() = re;
  z.imag() = im;
}

// Divergence, W(s, w) = −σ²(s, w): x = −(f s + b w)/σ², y = w/σ, each column of v one pair.
UnstableRoots divergent(const QuadratureForm& form, const Vector& sigma, const MatrixView& v) {
  const Matrix& f = form.first.root();
  const Index q = f.cols();
  Matrix x = lapack::multiply(f, v.topRows(q));
  lapack::multiply_into(x, 1, form.b, false, v.bottomRows(v.rows() - q), false, 1);
  UnstableRoots roots(x.rows() + v.rows() - q, sigma.size());
  for (Index k = 0; k < sigma.size(); ++k) {
    ComplexVector right(x.rows() + v.rows() - q);
    right << (-x.col(k) / (sigma(k) * sigma(k))).cast<Complex>(), (v.col(k).tail(v.rows() - q) / sigma(k)).cast<Complex>();
    roots.set(k, sigma(k), right, reversed(right, x.rows()));
  }
  shapes_of(form, roots.right);
  shapes_of(form, roots.left);
  return roots;
}

// W = [f b]ᵀ[f b] + diag(0, k₂), its lower triangle.
Matrix w_matrix(const QuadratureForm& form) {
  const Matrix& f = form.first.root();
  const Index q = f.cols();
  const Index r = form.b.cols();
  Matrix w(q + r, q + r);
  if (f.rows() == q) {  // a square f is lower triangular
    w.topLeftCorner(q, q) = lapack::gram_of_lower(f);
    w.bottomLeftCorner(r, q) = form.b.transpose();
    lapack::multiply_lower_right(f, w.bottomLeftCorner(r, q));
  } else {
    w.topLeftCorner(q, q) = lapack::gram_lower(f);
    lapack::multiply_into(w.bottomLeftCorner(r, q), 1, form.b, true, f, false, 0);
  }
  w.bottomRightCorner(r, r) = lapack::gram_lower(form.b);
  w.bottomRightCorner(r, r).triangularView<Eigen::Lower>() += form.second.k();
  return w;
}

// Is an eigenvalue of W below 1e-8 of the largest, so that its ω has 8 digits and less? Sturm counts, before any vector
// is computed.
bool small_frequencies(const lapack::Tridiagonal& w, double norm_w) {
  constexpr double smallest_ratio = 1e-8;
  double largest = norm_w;  // to a factor of two
  while (largest > 0 && w.below(0.5 * largest) == w.size()) largest *= 0.5;
  return w.below(smallest_ratio * largest) > 0;
}

// An error ε‖W‖ in ω² is one of ε‖W‖/2ω in ω, while a backward error nε in K moves ω by nε‖K‖‖X‖²ω/2. The eigenvalues
// of W are good enough while the first is below the second for every mode (s, w), column of v: ‖y‖ = ‖w‖/ω, and x =
// f⁻ᵀs, ‖x‖² ≥ ‖s‖²/‖K‖. x itself is asked only where that bound does not do.
bool accurate(const QuadratureForm& form, const Vector& omega, const MatrixView& v, double norm_w, double norm_k) {
  const Matrix& f = form.first.root();
  const Index q = f.cols();
  const double n = static_cast<double>(v.rows());
  for (Index i = 0; i < omega.size(); ++i) {
    const double square = omega(i) * omega(i), of_y = n * norm_k * v.col(i).tail(v.rows() - q).squaredNorm();
    Matrix x = v.col(i).head(q);
    if (norm_w <= of_y + n * square * x.squaredNorm()) continue;
    if (f.rows() == q)
      lapack::solve_lower_transposed(f, x);
    else
      x = ((f * x + form.b * v.col(i).tail(v.rows() - q)) / square).eval();
    if (!(norm_w <= of_y + n * norm_k * square * x.squaredNorm())) return false;
  }
  return true;
}

// C = [fᵀ 0; bᵀ f₂], W = C Cᵀ: frequencies to ε‖C‖, not √ε.
QuadratureModes by_singular_values(const QuadratureForm& form) {
  const Matrix& f1 = form.first.root();
  const Matrix& f2 = form.second.root();
  const Index q = f1.cols();
  Matrix c = Matrix::Zero(q + form.b.cols(), f1.rows() + f2.cols());
  c.topLeftCorner(q, f1.rows()) = f1.transpose();
  c.bottomLeftCorner(form.b.cols(), f1.rows()) = form.b.transpose();
  c.bottomRightCorner(form.b.cols(), f2.cols()) = f2;
  auto svd = lapack::left_singular(std::move(c));
  svd.vectors.rowwise().reverseInPlace();
  QuadratureModes modes = recovered(form, svd.values.reverse(), svd.vectors);
  modes.solver = "singular values of C (real, n × n), as small frequencies ask for";
  return modes;
}

QuadratureModes by_w(const QuadratureForm& form) {
  Matrix w = w_matrix(form);
  const Index q = form.first.root().cols();
  const double norm_w = lapack::symmetric_norm(w);
  const double norm_k = std::max(lapack::symmetric_norm(w.topLeftCorner(q, q)), form.second.k().norm());  // ‖fᵀf‖ = ‖f fᵀ‖
  const lapack::Tridiagonal tridiagonal(std::move(w));
  const bool alternative = form.second.has_root();
  if (alternative && small_frequencies(tridiagonal, norm_w)) return by_singular_values(form);
  const auto e = tridiagonal.eigen();
  const Index unstable = (e.values.array() < 0).count();
  const Index m = e.values.size() - unstable;
  const Vector omega = e.values.tail(m).cwiseSqrt();
  if (alternative && !accurate(form, omega, e.vectors.rightCols(m), norm_w, norm_k)) return by_singular_values(form);
  QuadratureModes modes = recovered(form, omega, e.vectors.rightCols(m));
  if (unstable > 0) modes.unstable = divergent(form, (-e.values.head(unstable)).cwiseSqrt(), e.vectors.leftCols(unstable));
  modes.solver = "eigenvalues of W (real symmetric, n × n)";
  return modes;
}

// The groups exchanged: x ↔ y, b → −bᵀ. A motion (x, −jy) of the exchanged form is, times j, the motion (y, jx) → (y,
// −j(−x)) of this one.
QuadratureForm exchanged(const QuadratureForm& form) { return {-form.b.transpose(), form.second, form.first}; }

QuadratureModes exchanged_back(QuadratureModes modes) {
  std::swap(modes.x, modes.y);
  modes.y = -modes.y;
  // e^{λt}: (x, y) of the exchanged form is (y, x) of this one, without a sign
  UnstableRoots unstable(modes.x.rows() + modes.y.rows(), modes.unstable.count());
  for (Index k = 0; k < modes.unstable.count(); ++k) {
    ComplexVector right(modes.x.rows() + modes.y.rows());
    right << modes.unstable.right.col(k).tail(modes.x.rows()), modes.unstable.right.col(k).head(modes.y.rows());
    unstable.set(k, modes.unstable.lambda[static_cast<std::size_t>(k)], right, reversed(right, modes.x.rows()));
  }
  modes.unstable = std::move(unstable);
  return modes;
}

}  // namespace

void StiffnessBlock::shapes_of_root(MatrixSpan s) const {
  if (asked_.from_root) return asked_.from_root(s);
  lapack::solve_lower_transposed(root(), s);
  shapes(s);
}

ComplexVector reversed(const ComplexVector& right, Index in_phase) {
  ComplexVector left = right.conjugate();
  left.tail(left.size() - in_phase) *= -1;
  return left;
}

QuadratureModes quadrature_modes(const QuadratureForm& form) {
  if (form.first.has_root()) return by_w(form);
  if (form.second.has_root()) return exchanged_back(by_w(exchanged(form)));
  QuadratureModes modes = product_modes(form);
  form.first.shapes(modes.x);
  form.second.shapes(modes.y);
  shapes_of(form, modes.unstable.right);
  shapes_of(form, modes.unstable.left);
  return modes;
}

}  // namespace gyromode::dense
