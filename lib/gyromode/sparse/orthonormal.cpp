#include "gyromode/sparse/orthonormal.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <vector>

namespace gyromode::sparse {

Matrix orthonormal_combinations(const Matrix& gram, double least) {
  if (gram.rows() == 0) return Matrix(0, 0);
  const Eigen::SelfAdjointEigenSolver<Matrix> e(0.5 * (gram + gram.transpose()));
  std::vector<Index> kept;
  for (Index k = e.eigenvalues().size(); k-- > 0;) {
    if (e.eigenvalues()(k) > least) kept.push_back(k);
  }
  Matrix c(gram.rows(), static_cast<Index>(kept.size()));
  for (Index k = 0; k < c.cols(); ++k) {
    const Index from = kept[static_cast<std::size_t>(k)];
    c.col(k) = e.eigenvectors().col(from) / std::sqrt(e.eigenvalues()(from));
  }
  return c;
}

}  // namespace gyromode::sparse
