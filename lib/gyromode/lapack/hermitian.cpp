#include "gyromode/lapack/hermitian.h"

#include "gyromode/lapack/lapacke_complex.h"
#include "gyromode/lapack/status.h"

namespace gyromode::lapack {

HermitianEigen hermitian_eigen(const ComplexMatrix& a) {
  const Index n = a.rows();
  HermitianEigen e{Vector(n), ComplexMatrix(n, n)};
  if (n == 0) return e;
  const int order = dimension(n, "zheevd", largest_order(2, 6, 1));
  ComplexMatrix room = ComplexMatrix::Zero(n, n + 1);  // OpenBLAS 0.3.21 reads a column past a matrix in zgemv
  room.leftCols(n) = a;
  const int info = LAPACKE_zheevd(LAPACK_COL_MAJOR, 'V', 'L', order, room.data(), order, e.values.data());
  require_success(info, "zheevd", "off-diagonal elements did not converge to zero");
  e.vectors = room.leftCols(n);
  return e;
}

}  // namespace gyromode::lapack
