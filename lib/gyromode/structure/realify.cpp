#include "gyromode/structure/realify.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/hermitian.h"
#include "gyromode/lapack/small.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/system/scale.h"

#include <cmath>
#include <numbers>

namespace gyromode {

namespace {

double zero_of(const Vector& eigenvalues) { return zero_to_rounding(eigenvalues.size()) * eigenvalues.cwiseAbs().maxCoeff(); }

// ψ of (19) on the branch nearest to `near`; c and a − d below rounding of H leave it as it is.
double axis_angle(double a, double c, double d, double b, double near) {
  constexpr double quarter_turn = std::numbers::pi / 2;
  const double size = std::max({std::abs(a), std::abs(d), std::abs(b)});
  if (std::hypot(2 * c, a - d) <= 64 * epsilon * size) return near;
  const double psi = 0.5 * std::atan2(2 * c, a - d);
  const double quarters = (near - psi) / quarter_turn;
  return std::abs(quarters) <= 0.5 ? psi : psi + quarter_turn * std::round(quarters);
}

}  // namespace

std::string_view to_string(Realification how) {
  switch (how) {
    case Realification::partition: return "partition";
    case Realification::angle: return "angle";
    default: return "tridiagonal";
  }
}

// Of D H D, D powers of two that equilibrate it: a congruence keeps the inertia, and eigenvalues of a graded H itself
// would lose the small ones in the rounding of the large.
Vector Realified::equilibrated_eigenvalues() const {
  if (how == Realification::partition) return lapack::symmetric_eigenvalues(scaled(real_symmetric, equilibrating_scale(real_symmetric)));
  return lapack::hermitian_eigen(scaled(impedance, equilibrating_scale(impedance))).values;
}

Index Realified::negative() const {
  if (real_symmetric.size() == 0) return 0;
  const Vector values = equilibrated_eigenvalues();
  return (values.array() < -zero_of(values)).count();
}

int Realified::determinant_sign() const {
  if (real_symmetric.size() == 0) return 1;
  const Vector values = equilibrated_eigenvalues();
  if ((values.cwiseAbs().array() <= zero_of(values)).any()) return 0;
  return (values.array() < 0).count() % 2 == 0 ? 1 : -1;
}

Realified realify_by_partition(const ComplexMatrix& h, const std::vector<Index>& in_quadrature) {
  ComplexVector t = ComplexVector::Ones(h.rows());
  for (const Index i : in_quadrature) t(i) = Complex(0, -1);
  const ComplexMatrix star = t.conjugate().asDiagonal() * h * t.asDiagonal();
  return {h, t.asDiagonal(), star.real(), Realification::partition, std::nullopt};
}

Realified realify_by_angle(const ComplexMatrix& h, double near) {
  if (h.rows() != 2 || h.cols() != 2) throw InvalidArgument("S(ψ) is for 2 × 2 matrices");
  const double a = h(0, 0).real(), d = h(1, 1).real(), c = h(0, 1).real(), b = h(0, 1).imag();
  const double psi = axis_angle(a, c, d, b, near);
  const double cosine = std::cos(psi), sine = std::sin(psi), sine2 = std::sin(2 * psi);
  ComplexMatrix s(2, 2);
  s << cosine, Complex(0, sine), sine, Complex(0, -cosine);
  Matrix star(2, 2);
  star << a * cosine * cosine + d * sine * sine + c * sine2, b, b, a * sine * sine + d * cosine * cosine - c * sine2;
  return {h, std::move(s), std::move(star), Realification::angle, psi};
}

Realified realify_by_reflections(const ComplexMatrix& h) {
  const Index n = h.rows();
  if (n == 0) return {h, h, Matrix(0, 0), Realification::tridiagonal, std::nullopt};
  // Scaled to entries near 1: squares of very large and very small ones would leave the range of a double.
  const double largest = h.cwiseAbs().maxCoeff();
  const double unit = largest > 0 ? std::exp2(std::round(std::log2(largest))) : 1;
  const small::Tridiagonal t = small::tridiagonalised(h * (1 / unit));
  Matrix star = Matrix::Zero(n, n);
  ComplexVector phase = ComplexVector::Ones(n);
  star.diagonal() = t.diagonal * unit;
  for (Index i = 0; i + 1 < n; ++i) {
    const double beta = t.subdiagonal(i);
    phase(i + 1) = beta < 0 ? -phase(i) : phase(i);
    star(i + 1, i) = star(i, i + 1) = std::abs(beta) * unit;
  }
  return {h, t.q * phase.asDiagonal(), std::move(star), Realification::tridiagonal, std::nullopt};
}

Realified realify(const ComplexMatrix& h, const Structure& structure, double near) {
  if (structure.system_class() == SystemClass::quadrature) return realify_by_partition(h, structure.in_quadrature());
  return h.rows() == 2 ? realify_by_angle(h, near) : realify_by_reflections(h);
}

}  // namespace gyromode
