#include "gyromode/sparse/free_motions.h"

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

// Orthonormal columns: those that a matrix takes to zero, `null` of them, first.
struct Kernel {
  Matrix left, right;
  Index left_null = 0, right_null = 0, rank = 0;
  bool doubtful = false;
};

Kernel kernel_of(const Matrix& a, double scale) {
  Kernel k{Matrix::Identity(a.rows(), a.rows()), Matrix::Identity(a.cols(), a.cols()), a.rows(), a.cols()};
  if (a.rows() == 0 || a.cols() == 0 || scale == 0) return k;
  const Eigen::JacobiSVD<Matrix> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  for (Index i = 0; i < svd.singularValues().size(); ++i) {
    const double s = svd.singularValues()(i) / scale;
    if (s > rank_tolerance) ++k.rank;
    if (s > rank_tolerance / clearly && s < rank_tolerance * clearly) k.doubtful = true;
  }
  k.left = svd.matrixU().rowwise().reverse();
  k.right = svd.matrixV().rowwise().reverse();
  k.left_null -= k.rank;
  k.right_null -= k.rank;
  return k;
}

// Of F, symmetric.
void count_signs(const Matrix& f, FreeMotions& z) {
  if (f.cols() == 0) return;
  constexpr double rounding = 1e-7;
  const Vector values = Eigen::SelfAdjointEigenSolver<Matrix>(0.5 * (f + f.transpose()), Eigen::EigenvaluesOnly).eigenvalues();
  for (Index i = 0; i < values.size(); ++i) {
    if (values(i) < 0) ++z.negative;
    if (std::abs(values(i)) <= rounding * std::max(1.0, values.cwiseAbs().maxCoeff())) z.doubtful = true;
  }
}

void add_translations(const SparseSystem& s, const Groups& groups, FreeMotions& f) {
  const Matrix& given = s.translations();
  if (given.cols() == 0) return;
  f.t = given;
  for (Index k = 0; k < given.cols(); ++k) {
    Index where = 0;
    given.col(k).cwiseAbs().maxCoeff(&where);
    const bool across = groups.partition && groups.across[static_cast<std::size_t>(where)];
    f.t_across.push_back(across);
    if (groups.partition) {  // the other rows are rounding
      for (const Index i : groups.rows[across ? 0 : 1]) f.t(i, k) = 0;
    }
  }
  for (Index k = 0; k < given.cols(); ++k) {
    for (Index before = 0; before < k; ++before)
      f.t.col(k) -= f.t.col(before) * symmetric_times(s.mass(), f.t.col(before)).col(0).dot(f.t.col(k));
    f.t.col(k) /= std::sqrt(f.t.col(k).dot(symmetric_times(s.mass(), f.t.col(k)).col(0)));
  }
  f.mt = symmetric_times(s.mass(), f.t);
  f.kt = symmetric_times(s.stiffness(), f.t);
}

// Whether the rigid motions known span N.
bool spanned_by_known(const SparseSystem& s, const FreeMotions& f) {
  constexpr double rounding = 1e-6;  // N is known to that, as above
  if (s.rigid().cols() == 0) return false;
  const Matrix mr = symmetric_times(s.mass(), s.rigid()), inside = f.n.transpose() * mr, gram = s.rigid().transpose() * mr;
  Index rank = 0;
  const Eigen::SelfAdjointEigenSolver<Matrix> e(gram);
  for (Index k = 0; k < gram.cols(); ++k) {
    if (!(e.eigenvalues()(k) > rounding * e.eigenvalues().maxCoeff())) continue;
    const Vector c = e.eigenvectors().col(k);
    if ((inside * c).squaredNorm() < (1 - rounding) * e.eigenvalues()(k)) return false;
    ++rank;
  }
  return rank == f.nullity();
}

}  // namespace

FreeMotions free_motions_of(const SparseSystem& s, const Groups& groups, const StiffnessFactors& stiffness) {
  FreeMotions z;
  for (Matrix* columns : {&z.n, &z.mn, &z.gn, &z.drift, &z.response, &z.held, &z.t, &z.mt, &z.kt}) columns->resize(s.size(), 0);
  add_translations(s, groups, z);
  if (stiffness.nullity() == 0) return z;
  z.n.resize(s.size(), stiffness.nullity());
  for (Index b = 0, at = 0; b < stiffness.blocks(); ++b) {
    const Index r = stiffness.nullity(b);
    z.n.middleCols(at, r) = stiffness.null_space(b);
    at += r;
    z.across.insert(z.across.end(), static_cast<std::size_t>(r), stiffness.across(b));
  }
  const Matrix p = lapack::multiply_tn(z.n, skew_times(s.gyroscopic(), z.n)), coupling = 0.5 * (p - p.transpose());
  const Index first = std::count(z.across.begin(), z.across.end(), false), second = z.nullity() - first;
  const auto mark = [&](Index drifting, Index all) {
    for (Index k = 0; k < all; ++k) z.drifts.push_back(k < drifting);
  };
  if (groups.partition) {
    const Kernel k = kernel_of(coupling.topRightCorner(first, second), s.gyroscopic_size());
    z.pairs = k.rank;
    z.doubtful = k.doubtful;
    z.n.leftCols(first) = Matrix(z.n.leftCols(first) * k.left);
    z.n.rightCols(second) = Matrix(z.n.rightCols(second) * k.right);
    mark(k.left_null, first);
    mark(k.right_null, second);
  } else {
    const Kernel k = kernel_of(coupling, s.gyroscopic_size());
    z.pairs = k.rank / 2;
    z.doubtful = k.doubtful || k.rank % 2 != 0;
    z.n = z.n * k.right;
    mark(k.right_null, first);
  }
  z.mn = symmetric_times(s.mass(), z.n);
  z.gn = skew_times(s.gyroscopic(), z.n);
  std::vector<Index> drifting;
  for (Index k = 0; k < z.nullity(); ++k) {
    if (!z.drifts[static_cast<std::size_t>(k)]) continue;
    drifting.push_back(k);
    z.drift_across.push_back(z.across[static_cast<std::size_t>(k)]);
  }
  z.drift = z.n(Eigen::all, drifting);
  z.rigid = spanned_by_known(s, z);
  z.held = -z.gn(Eigen::all, drifting);
  z.held -= z.mn * (z.n.transpose() * z.held);
  z.response = Matrix::Zero(s.size(), z.drift.cols());
  for (Index b = 0; b < stiffness.blocks(); ++b) z.response += stiffness.solve(b, z.held);
  // F = 1 + (GN₀)ᵀK⁺GN₀.
  count_signs(Matrix::Identity(z.drift.cols(), z.drift.cols()) + z.held.transpose() * z.response, z);
  return z;
}

// NᵀG = −(GN)ᵀ.
void complete(const FreeMotions& free, Index leading, const Vector& omega, Matrix& re, Matrix& im) {
  const double sign = leading == 0 ? 1 : -1;
  Matrix &own = leading == 0 ? re : im, &other = leading == 0 ? im : re;
  for (Index i = 0; i < free.nullity(); ++i) {
    if (free.across[static_cast<std::size_t>(i)] != (leading == 1)) continue;
    const Vector there = own.transpose() * free.mn.col(i), wanted = sign * (other.transpose() * free.gn.col(i)).cwiseQuotient(omega);
    own += free.n.col(i) * (wanted - there).transpose();
  }
}

}  // namespace gyromode::sparse
