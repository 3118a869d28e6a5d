#include "gyromode/dense/mass_normal.h"

#include "gyromode/base/error.h"
#include "gyromode/lapack/status.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/system/scale.h"

namespace gyromode::dense {

MassNormal::MassNormal(const Matrix& m) : scale_(unit_diagonal_scale(m)), l_(scaled(m, scale_)) {
  if (lapack::cholesky(l_)) throw NotConverged("the mass matrix of a group is not numerically positive definite");
}

Matrix MassNormal::stiffness(const Matrix& k) const { return lapack::congruence(l_, scaled(k, scale_)); }

Matrix MassNormal::gyroscopic(const Matrix& g) const {
  Matrix a = scaled(g, scale_);
  lapack::solve_lower(l_, a);
  lapack::solve_lower_transposed_right(l_, a);
  return 0.5 * (a - a.transpose().eval());
}

Matrix MassNormal::coupling(const Matrix& b, const MassNormal& other) const {
  Matrix a = scale_.asDiagonal() * b * other.scale_.asDiagonal();
  lapack::solve_lower(l_, a);
  lapack::solve_lower_transposed_right(other.l_, a);
  return a;
}

std::optional<StiffnessFactor> StiffnessFactor::of(const Matrix& k, const StiffnessInertia& known) {
  if (known.factor) return StiffnessFactor(known.factor);
  if (known.negative > 0) return std::nullopt;
  PositiveFactor f{unit_diagonal_scale(k), {}};
  f.l = scaled(k, f.scale);
  if (lapack::cholesky(f.l)) return std::nullopt;
  return StiffnessFactor(std::make_shared<const PositiveFactor>(std::move(f)));
}

// F = E⁻¹ L.
Matrix StiffnessFactor::scaled_rows(const Vector& d) const {
  return (d.array() / factor_->scale.array()).matrix().asDiagonal() * factor_->l;
}

void StiffnessFactor::to_physical(MatrixSpan s) const {
  lapack::solve_lower_transposed(factor_->l, s);
  s = factor_->scale.asDiagonal() * s;
}

Matrix MassNormal::stiffness_root(const StiffnessFactor& k) const {
  Matrix f = k.scaled_rows(scale_);
  lapack::solve_lower(l_, f);
  return f;
}

void MassNormal::to_physical(MatrixSpan z) const {
  if (z.cols() == 0) return;  // of no rows, where there are none
  lapack::solve_lower_transposed(l_, z);
  z = scale_.asDiagonal() * z;
}

void MassNormal::to_physical(ComplexMatrix& z) const {
  if (z.cols() == 0) return;  // of no rows, where there are none
  Matrix re = z.real();
  Matrix im = z.imag();
  to_physical(re);
  to_physical(im);
  z.real() = re;
  z.imag() = im;
}

void MassNormal::to_physical(UnstableRoots& roots) const {
  to_physical(roots.right);
  to_physical(roots.left);
}

void MassNormal::to_normal(MatrixSpan q) const {
  q = scale_.cwiseInverse().asDiagonal() * q;
  lapack::multiply_lower_transposed(l_, q);
}

}  // namespace gyromode::dense
