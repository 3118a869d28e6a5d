#include "gyromode/lapack/singular.h"

#include "gyromode/lapack/reflectors.h"
#include "gyromode/lapack/status.h"

#include "gyromode/lapack/lapacke_complex.h"

#include <algorithm>

namespace gyromode::lapack {

SingularValues singular_value_decomposition(Matrix a) {
  const Index m = a.rows();
  const Index n = a.cols();
  const Index r = std::min(m, n);
  SingularValues s{Vector(r), Matrix(m, r), Matrix(r, n)};
  if (r == 0) return s;
  const Index limit = largest_order(5, 64, 0);
  const int info =
      LAPACKE_dgesdd(LAPACK_COL_MAJOR, 'S', dimension(m, "dgesdd", limit), dimension(n, "dgesdd", limit), a.data(), dimension(m, "dgesdd"),
                     s.values.data(), s.u.data(), dimension(m, "dgesdd"), s.vt.data(), dimension(r, "dgesdd"));
  require_success(info, "dgesdd", "the bidiagonal iteration did not converge");
  return s;
}

SingularValues bidiagonal_svd(Vector diagonal, Vector superdiagonal) {
  const Index n = diagonal.size();
  SingularValues s{std::move(diagonal), Matrix(n, n), Matrix(n, n)};
  if (n == 0) return s;
  const int order = dimension(n, "dbdsdc", largest_order(3, 4, 0));
  if (superdiagonal.size() == 0) superdiagonal = Vector::Zero(1);
  const int info = LAPACKE_dbdsdc(LAPACK_COL_MAJOR, 'U', 'I', order, s.values.data(), superdiagonal.data(), s.u.data(), order, s.vt.data(),
                                  order, nullptr, nullptr);
  require_success(info, "dbdsdc", "a singular value did not converge");
  return s;
}

LeftSingular left_singular(Matrix a) {
  const Index n = a.rows();
  if (n == 0) return {Vector(0), Matrix(0, 0)};
  const int order = dimension(n, "dgebrd");
  Reflectors q{std::move(a), Vector(n), 0};
  Vector diagonal(n), superdiagonal(std::max<Index>(n - 1, 1)), tau_right(n);
  const int info = LAPACKE_dgebrd(LAPACK_COL_MAJOR, order, order, q.vectors.data(), order, diagonal.data(), superdiagonal.data(),
                                  q.tau.data(), tau_right.data());
  require_success(info, "dgebrd", "");
  auto svd = bidiagonal_svd(std::move(diagonal), std::move(superdiagonal));
  multiply_left(q, svd.u);
  return {std::move(svd.values), std::move(svd.u)};
}

}  // namespace gyromode::lapack
