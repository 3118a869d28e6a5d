#include "gyromode/dense/ignorable.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/singular.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode::dense {

namespace {

Matrix orthonormal(const Matrix& a) { return lapack::orthogonal_completion(a).leftCols(a.cols()); }

// Eigenvalues of k up to the threshold are zero. In mass-normalised coordinates all entries have the unit of ω², and what a reduction should have
// made zero is rounding of ‖k‖ + ‖Γ‖²: an equilibration would blow it up.
NullBasis normwise(const Matrix& k, double threshold) {
  if (k.rows() == 0) return {Matrix(0, 0), 0, 0, 0};
  const auto e = lapack::symmetric_eigen(k);
  const Index negative = (e.values.array() < -threshold).count();
  const Index zero = (e.values.array() <= threshold).count() - negative;
  double gap = e.values.cwiseAbs().maxCoeff();
  for (const double lambda : e.values) gap = std::abs(lambda) > threshold ? std::min(gap, std::abs(lambda)) : gap;
  return {e.vectors.middleCols(negative, zero), zero, negative, gap > 0 ? threshold / gap : 0};
}

NullBasis null_basis(const NormalForm& form, double threshold) {
  const Index n = form.size();
  if (!form.quadrature()) return normwise(form.k, threshold);
  const Index p = form.split;
  const NullBasis one = normwise(form.k.topLeftCorner(p, p), threshold);
  const NullBasis two = normwise(form.k.bottomRightCorner(n - p, n - p), threshold);
  NullBasis basis{Matrix::Zero(n, one.first + two.first), one.first, one.negative + two.negative, std::max(one.error, two.error)};
  basis.vectors.topLeftCorner(p, one.first) = one.vectors;
  basis.vectors.bottomRightCorner(n - p, two.first) = two.vectors;
  return basis;
}

// null(k) = N₀ ⊕ N_g by the singular values of NᵀΓN (its off-diagonal block where there is a partition); those up to
// 8 n ε ‖Γ‖, or what the error of N makes of ‖Γ‖, are zero.
struct NullSplit {
  Matrix n0;
  Matrix ng;
};

NullSplit split_null(const NormalForm& form, const NullBasis& basis) {
  const Matrix& all = basis.vectors;
  const double relative = std::max(8 * static_cast<double>(form.size()) * std::numeric_limits<double>::epsilon(), std::min(basis.error, 1e-8));
  const double threshold = relative * form.gamma.norm();
  const bool blocks = form.quadrature();
  const Matrix left = blocks ? Matrix(all.leftCols(basis.first)) : all;
  const Matrix right = blocks ? Matrix(all.rightCols(all.cols() - basis.first)) : all;
  const Matrix g = left.transpose() * form.gamma * right;
  // Zero rows or columns make the decomposition square, so that both null spaces are complete.
  const Index m = std::max(g.rows(), g.cols());
  Matrix square = Matrix::Zero(m, m);
  square.topLeftCorner(g.rows(), g.cols()) = g;
  const auto svd = lapack::singular_value_decomposition(square);
  const Index rank = (svd.values.array() > threshold).count();
  const Matrix u = lapack::orthogonal_completion(svd.u.topLeftCorner(g.rows(), rank));
  const Matrix v = lapack::orthogonal_completion(svd.vt.topLeftCorner(rank, g.cols()).transpose());
  NullSplit s;
  if (blocks) {
    s.n0.resize(form.size(), g.rows() + g.cols() - 2 * rank);
    s.n0 << left * u.rightCols(g.rows() - rank), right * v.rightCols(g.cols() - rank);
    s.ng.resize(form.size(), 2 * rank);
    s.ng << left * u.leftCols(rank), right * v.leftCols(rank);
  } else {
    s.n0 = all * u.rightCols(g.rows() - rank);
    s.ng = all * u.leftCols(rank);
  }
  return s;
}

// Orthonormal columns spanning the complement of N₀, group by group where there is a partition.
Matrix complement(const NormalForm& form, const Matrix& n0, Index& split) {
  const Index n = form.size();
  const Index r0 = n0.cols();
  if (!form.quadrature()) return lapack::orthogonal_completion(n0).rightCols(n - r0);
  const Index p = form.split;
  Index in_first = 0;
  while (in_first < r0 && !n0.col(in_first).head(p).isZero(0)) ++in_first;
  Matrix c = Matrix::Zero(n, n - r0);
  split = p - in_first;
  const Index second = n - p - (r0 - in_first);
  c.topLeftCorner(p, split) = lapack::orthogonal_completion(n0.topLeftCorner(p, in_first)).rightCols(split);
  c.bottomRightCorner(n - p, second) = lapack::orthogonal_completion(n0.bottomRightCorner(n - p, r0 - in_first)).rightCols(second);
  return c;
}

// The given null vectors made orthonormal, within their groups.
Matrix orthonormal_by_group(const NullBasis& basis, const NormalForm& form) {
  if (!form.quadrature()) return orthonormal(basis.vectors);
  const Index p = form.split;
  const Index r = form.size() - p;
  const Index second = basis.vectors.cols() - basis.first;
  Matrix v = Matrix::Zero(form.size(), basis.vectors.cols());
  v.topLeftCorner(p, basis.first) = orthonormal(basis.vectors.topLeftCorner(p, basis.first));
  v.bottomRightCorner(r, second) = orthonormal(basis.vectors.bottomRightCorner(r, second));
  return v;
}

double rounding_threshold(const NormalForm& form) {
  const double scale = std::max(form.k.norm(), form.gamma.squaredNorm());
  return 8 * static_cast<double>(form.size()) * std::numeric_limits<double>::epsilon() * scale;
}

}  // namespace

Index Deflation::negative_in(const Matrix& k) const { return normwise(k, threshold).negative; }

Deflation deflate(NormalForm form, NullBasis basis) {
  Deflation d;
  d.threshold = rounding_threshold(form);
  basis.vectors = orthonormal_by_group(basis, form);
  for (;;) {  // every turn but the last removes at least one coordinate
    const NullSplit null = split_null(form, basis);
    if (null.n0.cols() == 0) {
      d.negative = basis.negative;
      d.gyroscopic_null = null.ng;
      d.zero_pairs += null.ng.cols() / 2;
      break;
    }
    Index split = form.split;
    Deflation::Step step;
    step.n0 = null.n0;
    step.c = complement(form, null.n0, split);
    step.gamma_0c = lapack::multiply(lapack::multiply_tn(step.n0, form.gamma), step.c);
    d.zero_pairs += null.n0.cols();
    d.ignorable += null.n0.cols();
    Matrix gamma = lapack::multiply_tn(step.c, lapack::multiply(form.gamma, step.c));
    Matrix k = lapack::multiply_tn(step.c, lapack::multiply(form.k, step.c)) + lapack::gram(step.gamma_0c);
    form = {0.5 * (gamma - gamma.transpose()), 0.5 * (k + k.transpose()), split};
    d.steps.push_back(std::move(step));
    if (form.size() == 0) break;
    basis = null_basis(form, d.threshold);
  }
  d.reduced = std::move(form);
  return d;
}

ComplexMatrix Deflation::expand(const ComplexMatrix& shapes, const ComplexVector& lambda) const {
  ComplexMatrix x = shapes;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    const ComplexMatrix a = -(step->gamma_0c * x) * lambda.cwiseInverse().asDiagonal();
    x = (step->c * x + step->n0 * a).eval();
  }
  return x;
}

}  // namespace gyromode::dense
