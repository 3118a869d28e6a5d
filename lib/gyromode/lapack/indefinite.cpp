#include "gyromode/lapack/indefinite.h"

#include "gyromode/lapack/status.h"

#include "gyromode/lapack/lapacke_complex.h"

#include <cmath>

namespace gyromode::lapack {

namespace {

constexpr Index spare_columns = 8;

// info > 0 of ?sytrf says that a block of D is exactly zero: the factorisation is complete, the inertia has a zero.
template <class Scalar, class Routine>
IndefiniteFactor<Scalar> factorise(Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> a, Routine routine, const char* name) {
  const Index n = a.rows();
  IndefiniteFactor<Scalar> f{std::move(a), std::vector<int>(static_cast<std::size_t>(n))};
  if (n == 0) return f;
  const int order = dimension(n, name);
  const int info = routine(LAPACK_COL_MAJOR, 'L', order, f.factor.data(), order, f.pivots.data());
  if (info < 0) require_success(info, name, "");
  return f;
}

template <class Scalar, class Routine>
auto back_substitute(const IndefiniteFactor<Scalar>& f, Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> b, Routine routine,
                     const char* name) {
  if (b.size() == 0) return b;
  const int order = dimension(f.factor.rows(), name);
  const int info =
      routine(LAPACK_COL_MAJOR, 'L', order, dimension(b.cols(), name), f.factor.data(), order, f.pivots.data(), b.data(), order);
  require_success(info, name, "");
  return b;
}

template <class Scalar, class Routine>
double estimated_condition(const IndefiniteFactor<Scalar>& f, double norm, Routine routine, const char* name) {
  if (f.factor.rows() == 0) return 1;
  const int order = dimension(f.factor.rows(), name);
  double rcond = 0;
  const int info = routine(LAPACK_COL_MAJOR, 'L', order, f.factor.data(), order, f.pivots.data(), norm, &rcond);
  require_success(info, name, "the condition could not be estimated");
  return rcond;
}

}  // namespace

IndefiniteFactor<double> factor_indefinite(Matrix a) { return factorise<double>(std::move(a), LAPACKE_dsytrf, "dsytrf"); }

// zgemv of OpenBLAS 0.3.21 (Haswell kernel) reads a column beyond the end of the matrix it is given, and zhetrf gives
// it A and the workspace: both get columns to spare.
IndefiniteFactor<Complex> factor_indefinite(ComplexMatrix a) {
  const Index n = a.rows();
  const auto with_spare_workspace = [n](int layout, char part, int order, Complex* matrix, int stride, int* pivots) {
    constexpr int block = 64;
    ComplexVector work = ComplexVector::Zero(n * (block + spare_columns));
    return LAPACKE_zhetrf_work(layout, part, order, matrix, stride, pivots, work.data(), order * block);
  };
  a.conservativeResizeLike(ComplexMatrix::Zero(n, n + spare_columns));
  return factorise<Complex>(std::move(a), with_spare_workspace, "zhetrf");
}

Matrix solve(const IndefiniteFactor<double>& f, Matrix b) { return back_substitute(f, std::move(b), LAPACKE_dsytrs, "dsytrs"); }
ComplexMatrix solve(const IndefiniteFactor<Complex>& f, ComplexMatrix b) {
  const Index columns = b.cols();
  b.conservativeResizeLike(ComplexMatrix::Zero(b.rows(), columns + spare_columns));
  const int count = dimension(columns, "zhetrs");
  const auto of_given = [count](int layout, char part, int order, int, const Complex* factor, int stride, const int* pivots, Complex* x,
                                int x_stride) {
    return LAPACKE_zhetrs_work(layout, part, order, count, factor, stride, pivots, x, x_stride);
  };
  return back_substitute(f, std::move(b), of_given, "zhetrs").leftCols(columns);
}

double reciprocal_condition(const IndefiniteFactor<double>& f, double norm) {
  return estimated_condition(f, norm, LAPACKE_dsycon, "dsycon");
}
double reciprocal_condition(const IndefiniteFactor<Complex>& f, double norm) {
  return estimated_condition(f, norm, LAPACKE_zhecon, "zhecon");
}

template <class Scalar>
Vector pivot_values(const IndefiniteFactor<Scalar>& f) {
  const Index n = f.factor.rows();
  Vector d(n);
  for (Index k = 0; k < n; ++k) {
    const double a = std::real(f.factor(k, k));
    if (f.pivots[static_cast<std::size_t>(k)] > 0) {
      d(k) = a;
      continue;
    }
    // D_k = [a, b̄; b, c]: the mean plus and minus the radius, the smaller one by the product to keep its digits.
    const double c = std::real(f.factor(k + 1, k + 1));
    const double b = std::abs(f.factor(k + 1, k));
    const double mean = 0.5 * (a + c);
    const double radius = std::hypot(0.5 * (a - c), b);
    const double large = mean >= 0 ? mean + radius : mean - radius;
    d(k) = large;
    d(k + 1) = large == 0 ? 0 : (a / large) * c - (b / large) * b;
    ++k;
  }
  return d;
}

template Vector pivot_values(const IndefiniteFactor<double>&);
template Vector pivot_values(const IndefiniteFactor<Complex>&);

}  // namespace gyromode::lapack
