#include "gyromode/sparse/stiffness.h"

#include "gyromode/sparse/inverse_iteration.h"
#include "gyromode/sparse/matrix.h"

#include <algorithm>

namespace gyromode::sparse {

StiffnessFactors::~StiffnessFactors() = default;

StiffnessFactors::StiffnessFactors(const SparseSystem& s, const Groups& groups) : system_(s) {
  for (const std::vector<Index>& rows : groups.rows) {
    if (rows.empty()) continue;
    Block b;
    b.rows = rows;
    b.across = groups.across[static_cast<std::size_t>(rows.front())];
    const SparseMatrix k = restricted(s.stiffness(), rows), m = restricted(s.mass(), rows);
    const std::vector<int> order = elimination_order(s, rows);
    const Vector diagonal = k.diagonal();
    const bool perhaps_definite = diagonal.minCoeff() > 0;
    const bool nothing = k.nonZeros() == 0;  // which MUMPS does not take
    for (const auto kind : {SymmetricFactor::Kind::definite, SymmetricFactor::Kind::indefinite}) {
      if (nothing || (kind == SymmetricFactor::Kind::definite && !perhaps_definite)) continue;
      b.kind = kind;
      b.factor = std::make_unique<SymmetricFactor>(k, order, SymmetricFactor::Keep::factors, kind);
      b.negative = b.factor->factor(k);
      if (b.negative == 0 && !b.factor->singular()) break;
    }
    const auto solve = [&](Matrix x) { return b.factor->solve(std::move(x)); };
    if (nothing || b.factor->singular() || least_form(solve, k, m) <= singular_margin) {
      b.null_space = null_space_of(k, m, order);
      b.negative = b.null_space.negative;
      b.kind = SymmetricFactor::Kind::indefinite;
      b.mass = m;
      b.factor.reset();
      factor_of(b);
    }
    blocks_.push_back(std::move(b));
  }
}

SymmetricFactor& StiffnessFactors::factor_of(const Block& of) const {
  if (!of.factor) {
    SparseMatrix a = restricted(system_.stiffness(), of.rows);
    if (of.null_space.shift != 0) a = SparseMatrix(a - of.null_space.shift * of.mass);
    of.factor = std::make_unique<SymmetricFactor>(a, elimination_order(system_, of.rows), SymmetricFactor::Keep::factors, of.kind);
    of.factor->factor(a);
  }
  return *of.factor;
}

void StiffnessFactors::release() const {
  for (const Block& b : blocks_) b.factor.reset();
}

Index StiffnessFactors::negative() const {
  Index all = 0;
  for (const Block& b : blocks_) all += b.negative;
  return all;
}

Index StiffnessFactors::nullity() const {
  Index all = 0;
  for (const Block& b : blocks_) all += b.null_space.basis.cols();
  return all;
}

Matrix StiffnessFactors::null_space(Index block) const {
  const Block& of = blocks_[static_cast<std::size_t>(block)];
  Matrix n = Matrix::Zero(system_.size(), nullity(block));
  if (n.cols() > 0) n(of.rows, Eigen::all) = of.null_space.basis;
  return n;
}

// (K − νM) x_{k+1} = b − νM x_k converges by ν/λ of the least λ that is not zero.
Matrix StiffnessFactors::solve_singular(const Block& of, const Matrix& b) const {
  const Matrix &n = of.null_space.basis, mn = symmetric_times(of.mass, n);
  const Matrix part = b - mn * (n.transpose() * b);
  const double ratio = of.null_space.shift / of.null_space.next;
  Matrix x = Matrix::Zero(b.rows(), b.cols());
  for (double left = 1; left > epsilon; left *= ratio) {
    x = factor_of(of).solve(part - of.null_space.shift * symmetric_times(of.mass, x));
    x -= n * (mn.transpose() * x);
    if (ratio == 0) break;
  }
  return x;
}

Matrix StiffnessFactors::solve(Index block, const Matrix& b) const {
  const Block& of = blocks_[static_cast<std::size_t>(block)];
  Matrix part(static_cast<Index>(of.rows.size()), b.cols());
  for (Index j = 0; j < b.cols(); ++j) {
    for (Index i = 0; i < part.rows(); ++i) part(i, j) = b(of.rows[static_cast<std::size_t>(i)], j);
  }
  part = of.null_space.basis.cols() > 0 ? solve_singular(of, part) : factor_of(of).solve(std::move(part));
  Matrix x = Matrix::Zero(b.rows(), b.cols());
  for (Index j = 0; j < b.cols(); ++j) {
    for (Index i = 0; i < part.rows(); ++i) x(of.rows[static_cast<std::size_t>(i)], j) = part(i, j);
  }
  return x;
}

}  // namespace gyromode::sparse
