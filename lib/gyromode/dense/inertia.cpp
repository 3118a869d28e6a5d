#include "gyromode/dense/inertia.h"

#include "gyromode/lapack/indefinite.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <limits>

namespace gyromode {

namespace {

template <class AnyMatrix>
Inertia by_pivots(const AnyMatrix& equilibrated, double terms) {
  if (equilibrated.rows() == 0) return {};
  const auto factor = lapack::factor_indefinite(equilibrated);
  const Vector d = lapack::pivot_values(factor);
  Inertia result;
  result.negative = (d.array() < 0).count();
  result.positive = (d.array() > 0).count();
  const double largest = std::max(d.cwiseAbs().maxCoeff(), terms);
  const double smallest = d.cwiseAbs().minCoeff();
  result.margin = smallest > 0 ? std::min(smallest / largest, lapack::reciprocal_condition(factor, norm1(equilibrated))) : 0;
  return result;
}

// Eigenvalues below −8 n ε of the largest.
Index below_zero(const Vector& values) {
  const double threshold = 8 * static_cast<double>(values.size()) * std::numeric_limits<double>::epsilon() * values.cwiseAbs().maxCoeff();
  return (values.array() < -threshold).count();
}

}  // namespace

Index clearly_negative(const Matrix& symmetric) {
  return symmetric.rows() == 0 ? 0 : below_zero(lapack::symmetric_eigenvalues(scaled(symmetric, equilibrating_scale(symmetric))));
}

Index clearly_negative(const ComplexMatrix& hermitian) {
  const Index n = hermitian.rows();
  const ComplexMatrix h = scaled(hermitian, equilibrating_scale(hermitian));
  Matrix embedded(2 * n, 2 * n);  // every eigenvalue twice
  embedded << h.real(), -h.imag(), h.imag(), h.real();
  return n == 0 ? 0 : below_zero(lapack::symmetric_eigenvalues(embedded)) / 2;
}

bool Inertia::doubtful() const {
  const double n = static_cast<double>(negative + positive);
  return !(margin > 8 * n * std::numeric_limits<double>::epsilon());
}

Inertia inertia(const Matrix& symmetric) { return by_pivots(scaled(symmetric, equilibrating_scale(symmetric)), 0); }
Inertia inertia(const ComplexMatrix& hermitian) { return by_pivots(scaled(hermitian, equilibrating_scale(hermitian)), 0); }
Inertia inertia_of_sum(const Matrix& symmetric) { return by_pivots(symmetric, 1); }
Inertia inertia_of_sum(const ComplexMatrix& hermitian) { return by_pivots(hermitian, 1); }

}  // namespace gyromode
