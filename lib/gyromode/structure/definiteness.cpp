#include "gyromode/structure/definiteness.h"

#include "gyromode/lapack/indefinite.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/system/scale.h"

#include <cmath>
#include <limits>
#include <optional>

namespace gyromode {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// A condition below 1/(100 n ε) leaves every eigenvalue a factor 10 above the threshold that calls it zero; dpocon and dsycon
// underestimate the condition rarely, and then by less than that.
bool clearly_regular(double reciprocal_condition, Index n) { return reciprocal_condition > 100 * static_cast<double>(n) * epsilon; }

std::optional<Definiteness> positive_by_cholesky(const Matrix& k) {
  if (!(k.diagonal().array() > 0).all()) return std::nullopt;
  Matrix l = k;
  if (lapack::cholesky(l)) return std::nullopt;
  const double rcond = lapack::reciprocal_condition(l, norm1(k));
  if (!clearly_regular(rcond, k.rows())) return std::nullopt;
  return Definiteness{0, 0, k.rows(), Matrix(k.rows(), 0), rcond};
}

std::optional<Definiteness> regular_by_pivots(const Matrix& k) {
  const auto factor = lapack::factor_indefinite(k);
  const Vector d = lapack::pivot_values(factor);
  if ((d.array() == 0).any()) return std::nullopt;
  const double rcond = lapack::reciprocal_condition(factor, norm1(k));
  if (!clearly_regular(rcond, k.rows())) return std::nullopt;
  const Index negative = (d.array() < 0).count();
  return Definiteness{negative, 0, k.rows() - negative, Matrix(k.rows(), 0), rcond};
}

Definiteness by_eigenvalues(const Matrix& k, const Vector& scale) {
  const Index n = k.rows();
  const auto e = lapack::symmetric_eigen(k);
  const double largest = e.values.cwiseAbs().maxCoeff();
  const double threshold = 8 * static_cast<double>(n) * epsilon * largest;
  Definiteness result;
  double smallest = largest;
  for (Index i = 0; i < n; ++i) {
    const double lambda = e.values(i);
    if (std::abs(lambda) <= threshold) {
      ++result.zero;
    } else {
      ++(lambda < 0 ? result.negative : result.positive);
      smallest = std::min(smallest, std::abs(lambda));
    }
  }
  result.margin = largest > 0 && result.zero < n ? smallest / largest : 0;
  // K̂ v = 0 means K (D v) = 0. Zero eigenvalues stand together, after the negative ones.
  result.null_space = scale.asDiagonal() * e.vectors.middleCols(result.negative, result.zero);
  result.null_space.colwise().normalize();
  return result;
}

}  // namespace

Sign Definiteness::sign() const {
  if (negative > 0) return Sign::indefinite;
  return zero > 0 ? Sign::semidefinite : Sign::positive;
}

Definiteness definiteness(const Matrix& k) {
  if (k.rows() == 0) return {};
  const Vector scale = equilibrating_scale(k);
  const Matrix equilibrated = scaled(k, scale);
  if (auto decided = positive_by_cholesky(equilibrated)) return *decided;
  if (auto decided = regular_by_pivots(equilibrated)) return *decided;
  return by_eigenvalues(equilibrated, scale);
}

}  // namespace gyromode
