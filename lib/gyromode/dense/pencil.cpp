#include "gyromode/dense/pencil.h"

#include "gyromode/lapack/general.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace gyromode::dense {

namespace {

using HermitianEigen = Eigen::SelfAdjointEigenSolver<ComplexMatrix>;

// B = ±R with R > 0: R^{-½} A R^{-½} is Hermitian, its eigenvalues real.
std::vector<PencilRoot> definite_pencil(const ComplexMatrix& a, const HermitianEigen& b, double sign) {
  const ComplexMatrix root = b.eigenvectors() * b.eigenvalues().cwiseAbs().cwiseSqrt().cwiseInverse().asDiagonal();
  const HermitianEigen e(root.adjoint() * a * root);
  std::vector<PencilRoot> roots;
  for (Index k = 0; k < a.rows(); ++k) {
    const ComplexVector y = root * e.eigenvectors().col(k);
    const double length = y.norm();
    roots.push_back({sign * e.eigenvalues()(k), y / length, sign / (length * length)});
  }
  return roots;
}

std::vector<PencilRoot> indefinite_pencil(const ComplexMatrix& a, const ComplexMatrix& b) {
  const Index n = a.rows();
  const Eigen::PartialPivLU<ComplexMatrix> lu(b);
  const auto e = lapack::general_eigen(ComplexMatrix(lu.solve(a)));
  std::vector<PencilRoot> roots;
  for (Index k = 0; k < n; ++k) {
    const ComplexVector y = e.vectors.col(k);
    // The vector of the mirrored root μ̄ is the left vector of μ: the partner is the column with the largest |y₋ᴴ B y|.
    const ComplexVector by = b * y;
    double partner = 0;
    for (Index i = 0; i < n; ++i) partner = std::max(partner, std::abs(e.vectors.col(i).dot(by)));
    const double own = std::real(y.dot(by));
    const bool on_axis = std::abs(e.values(k).imag()) <= 1e-12 * std::abs(e.values(k)) && std::abs(own) >= 0.5 * partner;
    roots.push_back({on_axis ? Complex(e.values(k).real(), 0) : e.values(k), y, on_axis ? own : partner});
  }
  return roots;
}

}  // namespace

std::vector<PencilRoot> self_adjoint_pencil(const ComplexMatrix& a, const ComplexMatrix& b) {
  const HermitianEigen eb(b);
  const Vector& beta = eb.eigenvalues();
  constexpr double condition_limit = 1e7;
  const double weakest = beta.cwiseAbs().minCoeff();
  const double strongest = beta.cwiseAbs().maxCoeff();
  if (strongest <= condition_limit * weakest && weakest > 0) {
    if (beta.minCoeff() > 0) return definite_pencil(a, eb, 1);
    if (beta.maxCoeff() < 0) return definite_pencil(a, eb, -1);
  }
  return indefinite_pencil(a, b);
}

}  // namespace gyromode::dense
