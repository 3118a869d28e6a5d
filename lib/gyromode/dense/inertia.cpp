#include "gyromode/dense/inertia.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/definite.h"
#include "gyromode/lapack/indefinite.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <optional>

namespace gyromode {

namespace {

double margin_of(const Vector& pivots, double terms, double reciprocal_condition) {
  const double largest = std::max(pivots.cwiseAbs().maxCoeff(), terms);
  return std::min(pivots.cwiseAbs().minCoeff() / largest, reciprocal_condition);
}

// Above all modes −H is positive definite, below all of a stable K > 0 H is: where the diagonal allows it a Cholesky
// factorisation is tried first. It stops at the first pivot that says no.
template <class AnyMatrix>
std::optional<Inertia> by_cholesky(const AnyMatrix& equilibrated, double terms) {
  constexpr Index worth_it_from = 64;
  const Index n = equilibrated.rows();
  if (n < worth_it_from) return std::nullopt;
  const Vector diagonal = equilibrated.diagonal().real();
  const bool negative = (diagonal.array() < 0).all();
  if (!negative && !(diagonal.array() > 0).all()) return std::nullopt;
  const auto factor = lapack::factor_definite(negative ? AnyMatrix(-equilibrated) : equilibrated, norm1(equilibrated));
  if (!factor) return std::nullopt;
  return Inertia{negative ? n : 0, negative ? 0 : n, margin_of(factor->pivots, terms, factor->reciprocal_condition)};
}

template <class AnyMatrix>
Inertia by_pivots(const AnyMatrix& equilibrated, double terms) {
  if (equilibrated.rows() == 0) return {};
  if (const auto definite = by_cholesky(equilibrated, terms)) return *definite;
  const auto factor = lapack::factor_indefinite(equilibrated);
  const Vector d = lapack::pivot_values(factor);
  Inertia result;
  result.negative = (d.array() < 0).count();
  result.positive = (d.array() > 0).count();
  result.margin = (d.array() == 0).any() ? 0 : margin_of(d, terms, lapack::reciprocal_condition(factor, norm1(equilibrated)));
  return result;
}

// Eigenvalues below −8 n ε of the largest.
Index below_zero(const Vector& values) {
  const double threshold = zero_to_rounding(values.size()) * values.cwiseAbs().maxCoeff();
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

Inertia inertia(const Matrix& symmetric) { return by_pivots(scaled(symmetric, equilibrating_scale(symmetric)), 0); }
Inertia inertia(const ComplexMatrix& hermitian) { return by_pivots(scaled(hermitian, equilibrating_scale(hermitian)), 0); }
Inertia inertia_of_sum(const Matrix& symmetric) { return by_pivots(symmetric, 1); }
Inertia inertia_of_sum(const ComplexMatrix& hermitian) { return by_pivots(hermitian, 1); }

}  // namespace gyromode
