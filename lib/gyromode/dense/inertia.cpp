#include "gyromode/dense/inertia.h"

#include "gyromode/lapack/indefinite.h"
#include "gyromode/system/scale.h"

#include <limits>

namespace gyromode {

namespace {

template <class AnyMatrix>
Inertia by_pivots(const AnyMatrix& a) {
  if (a.rows() == 0) return {};
  const Vector d = lapack::pivot_values(lapack::factor_indefinite(scaled(a, equilibrating_scale(a))));
  Inertia result;
  result.negative = (d.array() < 0).count();
  result.positive = (d.array() > 0).count();
  const double largest = d.cwiseAbs().maxCoeff();
  result.margin = largest > 0 ? d.cwiseAbs().minCoeff() / largest : 0;
  return result;
}

template <class AnyMatrix>
Index negative_pivots(const AnyMatrix& a) {
  if (a.rows() == 0) return 0;
  const Vector d = lapack::pivot_values(lapack::factor_indefinite(scaled(a, equilibrating_scale(a))));
  const double threshold = 8 * static_cast<double>(a.rows()) * std::numeric_limits<double>::epsilon() * d.cwiseAbs().maxCoeff();
  return (d.array() < -threshold).count();
}

}  // namespace

Index clearly_negative(const Matrix& symmetric) { return negative_pivots(symmetric); }
Index clearly_negative(const ComplexMatrix& hermitian) { return negative_pivots(hermitian); }

bool Inertia::doubtful() const {
  const double n = static_cast<double>(negative + positive);
  return !(margin > 8 * n * std::numeric_limits<double>::epsilon());
}

Inertia inertia(const Matrix& symmetric) { return by_pivots(symmetric); }
Inertia inertia(const ComplexMatrix& hermitian) { return by_pivots(hermitian); }

}  // namespace gyromode
