#include "gyromode/sparse/resting.h"

#include "gyromode/sparse/factor.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/orthonormal.h"

#include "gyromode/lapack/multiply.h"

#include <Eigen/Eigenvalues>

namespace gyromode::sparse {

Index negative_at_rest(const SparseSystem& s, const Groups& groups, double mu) {
  Index negative = -s.translations().cols();
  for (const std::vector<Index>& rows : groups.rows) {
    if (rows.empty()) continue;
    const SparseMatrix a = restricted(s.stiffness(), rows) - mu * restricted(s.mass(), rows);
    SymmetricFactor factor(a, elimination_order(s, rows), SymmetricFactor::Keep::counts);
    negative += factor.factor(a);
  }
  return negative;
}

// Real and imaginary parts apart, each as far as it is there.
Vector resting_squares(const SparseSystem& s, const FreeMotions& free, const std::vector<RitzMode>& shapes) {
  Matrix x(s.size(), 2 * static_cast<Index>(shapes.size()));
  Index columns = 0;
  for (const RitzMode& m : shapes) {
    for (Vector part : {Vector(m.shape.real()), Vector(m.shape.imag())}) {
      if (free.nullity() > 0) part -= free.n * (free.mn.transpose() * part);
      const double size = part.norm();
      if (size > 0) x.col(columns++) = part / size;
    }
  }
  x.conservativeResize(Eigen::NoChange, columns);
  constexpr double least = 1e-12;
  const Matrix c = orthonormal_combinations(lapack::multiply_tn(x, symmetric_times(s.mass(), x)) / s.mass().diagonal().maxCoeff(), least);
  const Matrix k = c.transpose() * lapack::multiply_tn(x, symmetric_times(s.stiffness(), x)) * c / s.mass().diagonal().maxCoeff();
  return Eigen::SelfAdjointEigenSolver<Matrix>(k, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace gyromode::sparse
