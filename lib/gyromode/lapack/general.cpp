#include "gyromode/lapack/general.h"

#include "gyromode/lapack/status.h"

#include "gyromode/lapack/lapacke_complex.h"

namespace gyromode::lapack {

GeneralEigen general_eigen(Matrix a) {
  const Index n = a.rows();
  GeneralEigen e{ComplexVector(n), ComplexMatrix(n, n)};
  if (n == 0) return e;
  const int order = dimension(n, "dgeev");
  Vector re(n);
  Vector im(n);
  Matrix packed(n, n);
  const int info =
      LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'V', order, a.data(), order, re.data(), im.data(), nullptr, 1, packed.data(), order);
  require_success(info, "dgeev", "the QR algorithm did not find all eigenvalues");
  for (Index k = 0; k < n; ++k) {
    e.values(k) = Complex(re(k), im(k));
    if (im(k) == 0) {
      e.vectors.col(k) = packed.col(k).cast<Complex>();
    } else {  // LAPACK packs a conjugate pair as real part, imaginary part
      e.values(k + 1) = std::conj(e.values(k));
      e.vectors.col(k).real() = packed.col(k);
      e.vectors.col(k).imag() = packed.col(k + 1);
      e.vectors.col(k + 1) = e.vectors.col(k).conjugate();
      ++k;
    }
  }
  return e;
}

GeneralEigen general_eigen(ComplexMatrix a) {
  const Index n = a.rows();
  GeneralEigen e{ComplexVector(n), ComplexMatrix(n, n)};
  if (n == 0) return e;
  const int order = dimension(n, "zgeev");
  const int info = LAPACKE_zgeev(LAPACK_COL_MAJOR, 'N', 'V', order, a.data(), order, e.values.data(), nullptr, 1, e.vectors.data(), order);
  require_success(info, "zgeev", "the QR algorithm did not find all eigenvalues");
  return e;
}

}  // namespace gyromode::lapack
