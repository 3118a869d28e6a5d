#include "gyromode/sparse/inverse_iteration.h"

#include "gyromode/sparse/lanczos.h"

#include <algorithm>
#include <cmath>

namespace gyromode::sparse {

double least_form(const std::function<Matrix(Matrix)>& solve, const SparseMatrix& a, const SparseMatrix& mass) {
  constexpr Index columns = 2;
  constexpr int steps = 3;
  constexpr unsigned draw = 7;
  Matrix x = random_shapes(a.cols(), columns, draw);
  for (int step = 0; step < steps; ++step) {
    x = solve(step == 0 ? x : symmetric_times(mass, x));
    for (Index j = 0; j < x.cols(); ++j) {
      if (!x.col(j).allFinite()) return 0;
      x.col(j) /= x.col(j).norm();
    }
  }
  const Matrix ax = symmetric_times(a, x);
  const Vector sizes = sizes_of(a, x.cwiseAbs());
  double least = infinity;
  for (Index j = 0; j < x.cols(); ++j) least = std::min(least, std::abs(x.col(j).dot(ax.col(j))) / sizes(j));
  return least;
}

}  // namespace gyromode::sparse
