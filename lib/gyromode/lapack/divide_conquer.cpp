#include "gyromode/lapack/divide_conquer.h"

#include "gyromode/lapack/rank_one_join.h"
#include "gyromode/lapack/status.h"
#include "gyromode/lapack/team.h"

#include "gyromode/lapack/lapacke_complex.h"

#include <algorithm>
#include <cmath>

namespace gyromode::lapack {

namespace {

// Into the rows and columns [first, first + n) of `vectors`.
int solve_part(Vector& d, Vector& e, Matrix& vectors, Index first, Index n) {
  return LAPACKE_dstedc(LAPACK_COL_MAJOR, 'I', dimension(n, "dstedc", largest_order(1, 4, 1)), d.data() + first, e.data() + first,
                        &vectors(first, first), static_cast<int>(vectors.rows()));
}

void require_converged(int info) { require_success(info, "dstedc", "an eigenvalue of a sub-block did not converge"); }

// T = diag(T₁, T₂) + |e| z zᵀ at the cut, z = e_cut ± e_{cut+1}: both halves at once, then the join.
SymmetricEigen joined_halves(Vector d, Vector e) {
  const Index n = d.size();
  const Index cut = n / 2;
  const double coupling = e(cut - 1);
  d(cut - 1) -= std::abs(coupling);
  d(cut) -= std::abs(coupling);
  Matrix vectors = Matrix::Zero(n, n);
  int info1 = 0;
  int info2 = 0;
  Team(2).run([&](int part) {
    if (part == 0) info1 = solve_part(d, e, vectors, 0, cut);
    if (part == 1) info2 = solve_part(d, e, vectors, cut, n - cut);
  });
  require_converged(info1);
  require_converged(info2);

  join_rank_one(d, vectors, cut, coupling);
  return {std::move(d), std::move(vectors)};
}

}  // namespace

SymmetricEigen tridiagonal_eigen(Vector diagonal, Vector subdiagonal) {
  const Index n = diagonal.size();
  const double unit = n == 0 ? 0 : std::max(diagonal.lpNorm<Eigen::Infinity>(), n > 1 ? subdiagonal.lpNorm<Eigen::Infinity>() : 0);
  if (unit > 0 && threads_for(n) > 1) {
    SymmetricEigen e = joined_halves(diagonal / unit, subdiagonal / unit);
    e.values *= unit;
    return e;
  }
  SymmetricEigen e{std::move(diagonal), Matrix(n, n)};
  if (n > 0) require_converged(solve_part(e.values, subdiagonal, e.vectors, 0, n));
  return e;
}

}  // namespace gyromode::lapack
