#include "gyromode/lapack/triangular.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/small.h"
#include "gyromode/lapack/status.h"

#include <cblas.h>
#include "gyromode/lapack/lapacke_complex.h"

#include <utility>
#include <vector>

namespace gyromode::lapack {

namespace {

void triangular_solve(CBLAS_SIDE side, CBLAS_TRANSPOSE transpose, const MatrixView& l, MatrixSpan b) {
  if (b.size() == 0) return;
  cblas_dtrsm(CblasColMajor, side, CblasLower, transpose, CblasNonUnit, dimension(b.rows(), "dtrsm"), dimension(b.cols(), "dtrsm"), 1,
              l.data(), dimension(l.outerStride(), "dtrsm"), b.data(), dimension(b.outerStride(), "dtrsm"));
}

void triangular_multiply(CBLAS_SIDE side, CBLAS_TRANSPOSE transpose, const MatrixView& l, MatrixSpan b) {
  if (b.size() == 0) return;
  cblas_dtrmm(CblasColMajor, side, CblasLower, transpose, CblasNonUnit, dimension(b.rows(), "dtrmm"), dimension(b.cols(), "dtrmm"), 1,
              l.data(), dimension(l.outerStride(), "dtrmm"), b.data(), dimension(b.outerStride(), "dtrmm"));
}

}  // namespace

std::optional<Index> cholesky(MatrixSpan a) {
  const Index n = a.rows();
  if (n == 0) return std::nullopt;
  const int info = LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', dimension(n, "dpotrf"), a.data(), dimension(a.outerStride(), "dpotrf"));
  if (info > 0) return info - 1;
  require_success(info, "dpotrf", "");
  for (Index j = 0; j < n; ++j) {
    if (!(a(j, j) > 0)) return j;  // NaN passes through dpotrf
  }
  for (Index j = 1; j < n; ++j) a.col(j).head(j).setZero();
  return std::nullopt;
}

Cholesky::Cholesky(Matrix a) : l_(std::move(a)), positive_(!cholesky(l_)) {}

Matrix Cholesky::solve(Matrix b) const {
  solve_lower(l_, b);
  solve_lower_transposed(l_, b);
  return b;
}

double reciprocal_condition(const MatrixView& l, double norm) {
  if (l.rows() == 0) return 1;
  double rcond = 0;
  Vector work(3 * l.rows());
  std::vector<int> signs(static_cast<std::size_t>(l.rows()));
  const int info = LAPACKE_dpocon_work(LAPACK_COL_MAJOR, 'L', dimension(l.rows(), "dpocon"), l.data(), dimension(l.outerStride(), "dpocon"),
                                       norm, &rcond, work.data(), signs.data());
  require_success(info, "dpocon", "the condition could not be estimated");
  return rcond;
}

void solve_lower(const MatrixView& l, MatrixSpan b) { triangular_solve(CblasLeft, CblasNoTrans, l, b); }
void solve_lower_transposed(const MatrixView& l, MatrixSpan b) { triangular_solve(CblasLeft, CblasTrans, l, b); }
void solve_lower_transposed_right(const MatrixView& l, MatrixSpan b) { triangular_solve(CblasRight, CblasTrans, l, b); }
void multiply_lower_transposed(const MatrixView& l, MatrixSpan b) { triangular_multiply(CblasLeft, CblasTrans, l, b); }
void multiply_lower_right(const MatrixView& l, MatrixSpan b) { triangular_multiply(CblasRight, CblasNoTrans, l, b); }

Matrix gram_of_lower(Matrix l) {
  if (l.size() == 0) return l;
  const int order = dimension(l.rows(), "dlauum");
  require_success(LAPACKE_dlauum_work(LAPACK_COL_MAJOR, 'L', order, l.data(), order), "dlauum", "");
  return l;
}

Matrix congruence(const MatrixView& l, Matrix a) {
  if (a.size() == 0) return a;
  const int info = LAPACKE_dsygst_work(LAPACK_COL_MAJOR, 1, 'L', dimension(a.rows(), "dsygst"), a.data(),
                                       dimension(a.outerStride(), "dsygst"), l.data(), dimension(l.outerStride(), "dsygst"));
  require_success(info, "dsygst", "");
  mirror_lower(a);
  return a;
}

Matrix orthogonal_completion(const MatrixView& a) {
  const Index n = a.rows();
  Matrix q = Matrix::Identity(n, n);
  if (a.cols() == 0 || n == 0) return q;
  return small::orthogonal_factor(a);
}

Matrix orthonormal_columns(Matrix a) {
  if (a.size() == 0) return a;
  const int rows = dimension(a.rows(), "dgeqrf"), columns = dimension(a.cols(), "dgeqrf");
  Vector tau(a.cols());
  require_success(LAPACKE_dgeqrf(LAPACK_COL_MAJOR, rows, columns, a.data(), rows, tau.data()), "dgeqrf", "");
  require_success(LAPACKE_dorgqr(LAPACK_COL_MAJOR, rows, columns, columns, a.data(), rows, tau.data()), "dorgqr", "");
  return a;
}

Matrix solve_general(Matrix a, Matrix b) {
  if (b.size() == 0) return b;
  const int order = dimension(a.rows(), "dgesv");
  std::vector<int> pivots(static_cast<std::size_t>(a.rows()));
  require_success(LAPACKE_dgesv(LAPACK_COL_MAJOR, order, dimension(b.cols(), "dgesv"), a.data(), order, pivots.data(), b.data(), order),
                  "dgesv", "a pivot is exactly zero");
  return b;
}

}  // namespace gyromode::lapack
