#include "gyromode/lapack/complex_lu.h"

#include "gyromode/lapack/status.h"

#include "gyromode/lapack/lapacke_complex.h"

namespace gyromode::lapack {

// info > 0 of zgetrf says that a pivot is exactly zero: the factorisation is complete, and solutions are not finite.
ComplexLu::ComplexLu(ComplexMatrix a) : factors_(std::move(a)), pivots_(static_cast<std::size_t>(factors_.rows())) {
  const int order = dimension(factors_.rows(), "zgetrf");
  if (order == 0) return;
  const int info = LAPACKE_zgetrf_work(LAPACK_COL_MAJOR, order, order, factors_.data(), order, pivots_.data());
  if (info < 0) require_success(info, "zgetrf", "");
}

ComplexMatrix ComplexLu::back_substitute(ComplexMatrix b, char which) const {
  if (b.size() == 0) return b;
  const int order = dimension(factors_.rows(), "zgetrs");
  require_success(LAPACKE_zgetrs_work(LAPACK_COL_MAJOR, which, order, dimension(b.cols(), "zgetrs"), factors_.data(), order, pivots_.data(),
                                      b.data(), order),
                  "zgetrs", "");
  return b;
}

ComplexMatrix ComplexLu::solve(ComplexMatrix b) const { return back_substitute(std::move(b), 'N'); }
ComplexMatrix ComplexLu::solve_adjoint(ComplexMatrix b) const { return back_substitute(std::move(b), 'C'); }

}  // namespace gyromode::lapack
