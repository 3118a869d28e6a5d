#include "gyromode/system/laws.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/status.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/system/scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// Smallest eigenvalue of the unit-diagonal A, and the coordinate that weighs most in its vector; beyond order 256 the
// smallest pivot or reciprocal condition, whichever is less.
struct Weakest {
  double value = 0;
  Index coordinate = 0;
};

Weakest weakest(const Matrix& unit_diagonal) {
  constexpr Index eigenvalues_up_to = 256;
  Weakest w;
  if (unit_diagonal.rows() <= eigenvalues_up_to) {
    const auto e = lapack::symmetric_eigen(unit_diagonal);
    w.value = e.values(0);
    e.vectors.col(0).cwiseAbs().maxCoeff(&w.coordinate);
    return w;
  }
  Matrix l = unit_diagonal;
  if (const auto failed = lapack::cholesky(l)) return {0, *failed};
  w.value = l.diagonal().cwiseAbs2().minCoeff(&w.coordinate);
  w.value = std::min(w.value, lapack::reciprocal_condition(l, norm1(unit_diagonal)));
  return w;
}

}  // namespace

void require_order(std::string_view what, Index n) {
  if (n <= most_coordinates) return;
  throw TooLarge(
      fmt::format("{} of order {} is too large: dense models have at most {} coordinates; leave coordinates out, or solve parts that "
                  "nothing couples one by one",
                  what, n, most_coordinates));
}

void require_square(std::string_view name, const Matrix& a) {
  if (a.rows() != a.cols())
    throw LawBroken::of(name, fmt::format("{} must be square: it has {} rows and {} columns", name, a.rows(), a.cols()));
  if (a.rows() == 0) throw LawBroken::of(name, fmt::format("{} must have at least one coordinate: it is empty", name));
}

void require_finite(std::string_view name, const Matrix& a) {
  for (Index j = 0; j < a.cols(); ++j) {
    for (Index i = 0; i < a.rows(); ++i) {
      if (!std::isfinite(a(i, j)))
        throw LawBroken::of(name, fmt::format("{} must be finite: entry ({},{}) = {}", name, i + 1, j + 1, a(i, j)));
    }
  }
}

void require_positive_definite(std::string_view name, const Matrix& a, const Labels& labels) {
  const Index n = a.rows();
  for (Index i = 0; i < n; ++i) {
    if (!(a(i, i) > 0)) {
      throw LawBroken::of(
          name, fmt::format("{} must be positive definite: diagonal entry ({},{}) = {:.6g} of coordinate '{}' is not above 0", name, i + 1,
                            i + 1, a(i, i), labels[static_cast<std::size_t>(i)]));
    }
  }
  const Weakest w = weakest(scaled(a, unit_diagonal_scale(a)));
  const double limit = static_cast<double>(n) * epsilon;
  if (w.value > limit) return;
  throw LawBroken::of(name, fmt::format("{} must be positive definite: scaled to unit diagonal its smallest eigenvalue is {:.3g}, not "
                                        "above n ε = {:.2g}; coordinate '{}' "
                                        "takes part most",
                                        name, w.value, limit, labels[static_cast<std::size_t>(w.coordinate)]));
}

}  // namespace gyromode
