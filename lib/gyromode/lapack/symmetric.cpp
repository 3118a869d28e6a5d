#include "gyromode/lapack/symmetric.h"

#include "gyromode/lapack/status.h"
#include "gyromode/lapack/tridiagonal.h"

#include "gyromode/lapack/lapacke_complex.h"

namespace gyromode::lapack {

SymmetricEigen symmetric_eigen(Matrix a) { return Tridiagonal(std::move(a)).eigen(); }

double symmetric_norm(const MatrixView& a) {
  if (a.size() == 0) return 0;
  double work = 0;  // not used for this norm
  return LAPACKE_dlansy_work(LAPACK_COL_MAJOR, 'F', 'L', dimension(a.rows(), "dlansy"), a.data(), dimension(a.outerStride(), "dlansy"),
                             &work);
}

Vector symmetric_eigenvalues(Matrix a) {
  const Index n = a.rows();
  Vector values(n);
  if (n == 0) return values;
  const int order = dimension(n, "dsyevd");
  const int info = LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'N', 'L', order, a.data(), order, values.data());
  require_success(info, "dsyevd", "off-diagonal elements did not converge to zero");
  return values;
}

SymmetricEigen symmetric_definite_eigen(Matrix a, Matrix b) {
  const Index n = a.rows();
  SymmetricEigen e{Vector(n), std::move(a)};
  if (n == 0) return e;
  const int order = dimension(n, "dsygvd", largest_order(2, 6, 1));
  const int info = LAPACKE_dsygvd(LAPACK_COL_MAJOR, 1, 'V', 'L', order, e.vectors.data(), order, b.data(), order, e.values.data());
  require_success(info, "dsygvd", info > order ? "the right-hand matrix is not positive definite" : "an eigenvalue did not converge");
  return e;
}

}  // namespace gyromode::lapack
