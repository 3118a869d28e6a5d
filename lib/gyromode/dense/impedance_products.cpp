#include "gyromode/dense/impedance.h"

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

CharacteristicProducts Impedance::characteristic_products(const ComplexMatrix& x) const {
  if (x.cols() == 0) return {};
  if (!quadrature()) return {times(k_rr_, x), times(g_ri_, x), times(m_rr_, x)};
  const Index p = split_, r = size() - p;
  const ComplexMatrix first = x.topRows(p), second = x.bottomRows(r);
  CharacteristicProducts y{ComplexMatrix(x.rows(), x.cols()), ComplexMatrix(x.rows(), x.cols()), ComplexMatrix(x.rows(), x.cols())};
  y.k.topRows(p) = times(k_rr_, first);
  y.k.bottomRows(r) = times(k_ii_, second);
  y.g.topRows(p) = times(g_ri_, second);
  y.g.bottomRows(r) = -times_transposed(g_ri_, first);
  y.m.topRows(p) = times(m_rr_, first);
  y.m.bottomRows(r) = times(m_ii_, second);
  return y;
}

}  // namespace gyromode::dense
