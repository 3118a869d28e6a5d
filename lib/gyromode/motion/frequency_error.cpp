#include "gyromode/motion/frequency_error.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/multiply.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// |XᴴR| and |XᵀR|, R = re + j im.
struct Projections {
  Matrix same, mirrored;
};

Projections projected(const Matrix& x_re, const Matrix& x_im, const Matrix& re, const Matrix& im) {
  const Matrix rr = lapack::multiply_tn(x_re, re), ii = lapack::multiply_tn(x_im, im), ri = lapack::multiply_tn(x_re, im),
               ir = lapack::multiply_tn(x_im, re);
  return {((rr + ii).cwiseAbs2() + (ri - ir).cwiseAbs2()).cwiseSqrt(), ((rr - ii).cwiseAbs2() + (ri + ir).cwiseAbs2()).cwiseSqrt()};
}

Projections projected_residuals(const ComponentMatrices& m, const ComplexMatrix& x, const Vector& omega) {
  const Matrix x_re = x.real(), x_im = x.imag();
  const Vector squares = omega.cwiseAbs2();
  Matrix re = lapack::multiply(m.stiffness, x_re), im = lapack::multiply(m.stiffness, x_im);
  re -= lapack::multiply(m.gyroscopic, x_im) * omega.asDiagonal();
  im += lapack::multiply(m.gyroscopic, x_re) * omega.asDiagonal();
  re -= lapack::multiply(m.mass, x_re) * squares.asDiagonal();
  im -= lapack::multiply(m.mass, x_im) * squares.asDiagonal();
  return projected(x_re, x_im, re, im);
}

// ε |X_l|ᵀ(|K| + ω_k|G| + ω_k²|M|)|X_k|.
Matrix rounding(const ComponentMatrices& m, const ComplexMatrix& x, const Vector& omega) {
  const Matrix size = x.cwiseAbs();
  Matrix terms = lapack::multiply(m.stiffness.cwiseAbs(), size);
  terms += lapack::multiply(m.gyroscopic.cwiseAbs(), size) * omega.asDiagonal();
  terms += lapack::multiply(m.mass.cwiseAbs(), size) * omega.cwiseAbs2().asDiagonal();
  return epsilon * lapack::multiply_tn(size, terms);
}

}  // namespace

Vector frequency_errors(const ComponentMatrices& m, const ComplexMatrix& x, const Vector& omega, const Vector& form, const Vector& bounds) {
  const Projections p = projected_residuals(m, x, omega);
  const Matrix noise = rounding(m, x, omega);
  Vector error(omega.size());
  for (Index k = 0; k < omega.size(); ++k) {
    double sum = (p.same(k, k) + noise(k, k)) / std::abs(form(k));
    for (Index l = 0; l < omega.size(); ++l) {
      const double both = std::sqrt(std::abs(form(l) * form(k)));
      const double there = (p.mirrored(l, k) + noise(l, k)) / both, here = (p.same(l, k) + noise(l, k)) / both;
      sum += std::min(there, there * there / (omega(l) + omega(k)));
      if (l != k && here > 0) sum += std::min(here, here * here / std::abs(omega(l) - omega(k)));
    }
    error(k) = std::min(sum, bounds(k));
  }
  return error;
}

}  // namespace gyromode
