#include "gyromode/lapack/definite.h"

#include "gyromode/lapack/lapacke_complex.h"
#include "gyromode/lapack/status.h"

#include <vector>

namespace gyromode::lapack {

namespace {

template <class AnyMatrix, class Factor, class Condition>
std::optional<DefiniteFactor> factorised(AnyMatrix& a, Index n, double norm, Factor factor, Condition condition, const char* names[2]) {
  const int order = dimension(n, names[0]);
  const int info = factor(LAPACK_COL_MAJOR, 'L', order, a.data(), order);
  if (info > 0) return std::nullopt;
  require_success(info, names[0], "");
  DefiniteFactor f{a.diagonal().head(n).cwiseAbs2(), 0};
  if (!(f.pivots.array() > 0).all()) return std::nullopt;  // NaN passes through
  require_success(condition(order, norm, &f.reciprocal_condition), names[1], "the condition could not be estimated");
  return f;
}

}  // namespace

std::optional<DefiniteFactor> factor_definite(Matrix a, double norm) {
  const Index n = a.rows();
  if (n == 0) return DefiniteFactor{Vector(0), 1};
  const auto condition = [&](int order, double of, double* result) {
    Vector work(3 * n);
    std::vector<int> signs(static_cast<std::size_t>(n));
    return LAPACKE_dpocon_work(LAPACK_COL_MAJOR, 'L', order, a.data(), order, of, result, work.data(), signs.data());
  };
  const char* names[] = {"dpotrf", "dpocon"};
  return factorised(a, n, norm, LAPACKE_dpotrf_work, condition, names);
}

// Columns to spare, as for zhetrf (see indefinite.cpp): zgemv of OpenBLAS 0.3.21 reads one beyond the end.
std::optional<DefiniteFactor> factor_definite(ComplexMatrix a, double norm) {
  constexpr Index spare_columns = 8;
  const Index n = a.rows();
  if (n == 0) return DefiniteFactor{Vector(0), 1};
  a.conservativeResizeLike(ComplexMatrix::Zero(n, n + spare_columns));
  const auto condition = [&](int order, double of, double* result) {
    ComplexVector work = ComplexVector::Zero(2 * n);
    Vector real(n);
    return LAPACKE_zpocon_work(LAPACK_COL_MAJOR, 'L', order, a.data(), order, of, result, work.data(), real.data());
  };
  const char* names[] = {"zpotrf", "zpocon"};
  return factorised(a, n, norm, LAPACKE_zpotrf_work, condition, names);
}

}  // namespace gyromode::lapack
