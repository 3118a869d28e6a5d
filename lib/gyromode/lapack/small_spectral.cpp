#include "gyromode/lapack/small.h"

#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

namespace gyromode::small {

Schur schur(const ComplexMatrix& a) {
  const Eigen::ComplexSchur<ComplexMatrix> f(a);
  return {f.matrixU(), f.matrixT()};
}

ComplexVector eigenvalues(const Matrix& a) { return Eigen::EigenSolver<Matrix>(a, false).eigenvalues(); }
Matrix exponential(const Matrix& a) { return a.exp(); }

}  // namespace gyromode::small
