#include "gyromode/dense/refinement/characteristic_products.h"

#include "gyromode/lapack/multiply.h"

namespace gyromode::dense {

namespace {

ComplexMatrix times(const Matrix& a, const ComplexMatrix& x) {
  ComplexMatrix y(a.rows(), x.cols());
  y.real() = lapack::multiply(a, x.real());
  y.imag() = lapack::multiply(a, x.imag());
  return y;
}

ComplexMatrix times_transposed(const Matrix& a, const ComplexMatrix& x) {
  ComplexMatrix y(a.cols(), x.cols());
  y.real() = lapack::multiply_tn(a, x.real());
  y.imag() = lapack::multiply_tn(a, x.imag());
  return y;
}

}  // namespace

CharacteristicProducts characteristic_products(const Impedance& h, const ComplexMatrix& x) {
  if (x.cols() == 0) return {};
  if (!h.quadrature()) return {times(h.stiffness_rr(), x), times(h.gyroscopic_ri(), x), times(h.mass_rr(), x)};
  const Index p = h.split();
  const Index r = h.size() - p;
  const ComplexMatrix first = x.topRows(p), second = x.bottomRows(r);
  CharacteristicProducts y{ComplexMatrix(x.rows(), x.cols()), ComplexMatrix(x.rows(), x.cols()), ComplexMatrix(x.rows(), x.cols())};
  y.k.topRows(p) = times(h.stiffness_rr(), first);
  y.k.bottomRows(r) = times(h.stiffness_ii(), second);
  y.g.topRows(p) = times(h.gyroscopic_ri(), second);
  y.g.bottomRows(r) = -times_transposed(h.gyroscopic_ri(), first);
  y.m.topRows(p) = times(h.mass_rr(), first);
  y.m.bottomRows(r) = times(h.mass_ii(), second);
  return y;
}

}  // namespace gyromode::dense
