#include "gyromode/sparse/zero_motions.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/sparse/matrix.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace gyromode::sparse {

namespace {

// N is known to ε‖K‖/λ of the softest motion beside it, G N to that part of ‖G‖.
constexpr double rank_tolerance = 1e-7, clearly = 1e3;

// Orthonormal columns, ascending singular values first: those that a matrix takes to zero, and its rank.
struct Kernel {
  Matrix left, right;
  Index rank = 0;
  bool doubtful = false;
};

Kernel kernel_of(const Matrix& a, double scale) {
  Kernel k;
  if (a.rows() == 0 || a.cols() == 0 || scale == 0) {
    k.left = Matrix::Identity(a.rows(), a.rows());
    k.right = Matrix::Identity(a.cols(), a.cols());
    return k;
  }
  const Eigen::JacobiSVD<Matrix> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  for (Index i = 0; i < svd.singularValues().size(); ++i) {
    const double s = svd.singularValues()(i) / scale;
    if (s > rank_tolerance) ++k.rank;
    if (s > rank_tolerance / clearly && s < rank_tolerance * clearly) k.doubtful = true;
  }
  k.left = svd.matrixU().rightCols(a.rows() - k.rank);
  k.right = svd.matrixV().rightCols(a.cols() - k.rank);
  return k;
}

// Of F, symmetric.
void count_signs(const Matrix& f, ZeroMotions& z) {
  if (f.cols() == 0) return;
  constexpr double rounding = 1e-7;
  const Vector values = Eigen::SelfAdjointEigenSolver<Matrix>(0.5 * (f + f.transpose()), Eigen::EigenvaluesOnly).eigenvalues();
  for (Index i = 0; i < values.size(); ++i) {
    if (values(i) < 0) ++z.negative;
    if (std::abs(values(i)) <= rounding * std::max(1.0, values.cwiseAbs().maxCoeff())) z.doubtful = true;
  }
}

}  // namespace

ZeroMotions zero_motions_of(const SparseSystem& s, const Groups& groups, const StiffnessFactors& stiffness) {
  ZeroMotions z;
  if (stiffness.nullity() == 0) return z;
  z.n.resize(s.size(), stiffness.nullity());
  for (Index b = 0, at = 0; b < stiffness.blocks(); ++b) {
    const Index r = stiffness.nullity(b);
    z.n.middleCols(at, r) = stiffness.null_space(b);
    at += r;
    const bool across = groups.partition && (stiffness.blocks() == 1 ? groups.rows[0].empty() : b == 1);
    z.across.insert(z.across.end(), static_cast<std::size_t>(r), across);
  }
  z.mn = symmetric_times(s.mass(), z.n);
  z.gn = skew_times(s.gyroscopic(), z.n);
  z.coupling = lapack::multiply_tn(z.n, z.gn);
  z.coupling = Matrix(0.5 * (z.coupling - z.coupling.transpose()));
  const double scale = s.gyroscopic_size();
  const Index first = std::count(z.across.begin(), z.across.end(), false), second = z.nullity() - first;
  Matrix a;  // N₀ = N a
  if (groups.partition) {
    const Kernel k = kernel_of(z.coupling.topRightCorner(first, second), scale);
    z.pairs = k.rank;
    z.doubtful = k.doubtful;
    a = Matrix::Zero(z.nullity(), k.left.cols() + k.right.cols());
    a.topLeftCorner(first, k.left.cols()) = k.left;
    a.bottomRightCorner(second, k.right.cols()) = k.right;
    z.drift_across.assign(static_cast<std::size_t>(k.left.cols()), false);
    z.drift_across.insert(z.drift_across.end(), static_cast<std::size_t>(k.right.cols()), true);
  } else {
    const Kernel k = kernel_of(z.coupling, scale);
    z.pairs = k.rank / 2;
    z.doubtful = k.doubtful || k.rank % 2 != 0;
    a = k.right;
    z.drift_across.assign(static_cast<std::size_t>(a.cols()), false);
  }
  z.drift = z.n * a;
  z.held = -(z.gn * a);
  z.held -= z.mn * (z.n.transpose() * z.held);
  z.response = Matrix::Zero(s.size(), a.cols());
  for (Index b = 0; b < stiffness.blocks(); ++b) z.response += stiffness.solve(b, z.held);
  // F = 1 + (GN₀)ᵀK⁺GN₀.
  count_signs(Matrix::Identity(a.cols(), a.cols()) + z.held.transpose() * z.response, z);
  return z;
}

// NᵀG = −(GN)ᵀ.
void complete(const ZeroMotions& zero, Index leading, const Vector& omega, Matrix& re, Matrix& im) {
  const double sign = leading == 0 ? 1 : -1;
  Matrix &own = leading == 0 ? re : im, &other = leading == 0 ? im : re;
  for (Index i = 0; i < zero.nullity(); ++i) {
    if (zero.across[static_cast<std::size_t>(i)] != (leading == 1)) continue;
    const Vector there = own.transpose() * zero.mn.col(i), wanted = sign * (other.transpose() * zero.gn.col(i)).cwiseQuotient(omega);
    own += zero.n.col(i) * (wanted - there).transpose();
  }
}

}  // namespace gyromode::sparse
