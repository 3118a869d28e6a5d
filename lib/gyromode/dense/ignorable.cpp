#include "gyromode/dense/ignorable.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/structure/ranked_factor.h"
#include "gyromode/structure/ranked_skew.h"
#include "gyromode/system/laws.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

namespace {

using lapack::multiply;
using lapack::multiply_tn;

Matrix congruence(const Matrix& c, const Matrix& a) { return multiply_tn(c, multiply(a, c)); }

// null(K), each vector in one group where there is a partition.
struct Null {
  Matrix vectors;
  Index negative_first = 0, negative_second = 0;
  bool doubtful = false;
};

Null null_of(const SingularSystem& s, const Matrix& terms) {
  const Index n = s.size();
  const Index p = s.split < 0 ? n : s.split;
  const RankedFactor one = ranked_factor(s.stiffness.topLeftCorner(p, p), terms.topLeftCorner(p, p));
  const RankedFactor two = ranked_factor(s.stiffness.bottomRightCorner(n - p, n - p), terms.bottomRightCorner(n - p, n - p));
  Null null{Matrix::Zero(n, one.zero() + two.zero()), one.negative, two.negative, one.doubtful() || two.doubtful()};
  null.vectors.topLeftCorner(p, one.zero()) = one.null_space;
  null.vectors.bottomRightCorner(n - p, two.zero()) = two.null_space;
  null.vectors.colwise().normalize();
  return null;
}

bool in_first_group(const SingularSystem& s, const Eigen::Ref<const Vector>& v) { return s.split < 0 || !v.head(s.split).isZero(0); }

// N₀ and N_g. With a partition the columns of N_g in the first group come first.
struct Split {
  Matrix n0, ng;
  bool doubtful = false;
};

Split split_null(const SingularSystem& s, const Matrix& null) {
  const RankedSkew f = ranked_skew_on(s.gyroscopic, null);
  Split parts{multiply(null, f.null_space), Matrix(s.size(), static_cast<Index>(f.regular.size())),
              !(f.smallest_kept > 64 * static_cast<double>(s.size()) * epsilon)};
  std::vector<Index> regular = f.regular;
  std::stable_partition(regular.begin(), regular.end(), [&](Index k) { return in_first_group(s, null.col(k)); });
  for (std::size_t k = 0; k < regular.size(); ++k) parts.ng.col(static_cast<Index>(k)) = null.col(regular[k]);
  return parts;
}

// The coordinates in which N₀ is regular, as many as it has columns, by elimination with complete pivoting; N₀ is made
// the unit matrix there.
std::vector<Index> pivots_of(Matrix& n0) {
  std::vector<Index> rows;
  std::vector<bool> used(static_cast<std::size_t>(n0.rows()), false);
  for (Index k = 0; k < n0.cols(); ++k) {
    Index row = -1, column = k;
    for (Index j = k; j < n0.cols(); ++j) {
      for (Index i = 0; i < n0.rows(); ++i) {
        if (!used[static_cast<std::size_t>(i)] && (row < 0 || std::abs(n0(i, j)) > std::abs(n0(row, column)))) {
          row = i;
          column = j;
        }
      }
    }
    used[static_cast<std::size_t>(row)] = true;
    rows.push_back(row);
    n0.col(k).swap(n0.col(column));
    n0.col(k) /= n0(row, k);
    for (Index j = 0; j < n0.cols(); ++j) {
      if (j == k || n0(row, j) == 0) continue;
      n0.col(j) -= n0(row, j) * n0.col(k);
      n0(row, j) = 0;
    }
  }
  return rows;
}

// Columns of E combined (E := E R) until A R has no more than one entry a row. The pivot of a row is the column in
// which it is largest beside the root of the stiffness there: combining then does not bring the stiffness of a stiff
// coordinate into a soft one.
Matrix gathered(Matrix& a, const Vector& stiffness_weight) {
  const Index n = a.cols();
  Matrix r = Matrix::Identity(n, n);
  const Vector root = stiffness_weight.cwiseSqrt();
  std::vector<bool> row_used(static_cast<std::size_t>(a.rows()), false), column_used(static_cast<std::size_t>(n), false);
  for (Index step = 0; step < std::min(a.rows(), n); ++step) {
    Index row = -1, column = -1;
    for (Index k = 0; k < n; ++k) {
      for (Index i = 0; i < a.rows(); ++i) {
        if (row_used[static_cast<std::size_t>(i)] || column_used[static_cast<std::size_t>(k)] || a(i, k) == 0) continue;
        if (row < 0 || std::abs(a(i, k)) * root(column) > std::abs(a(row, column)) * root(k) ||
            (root(k) == 0 && root(column) == 0 && std::abs(a(i, k)) > std::abs(a(row, column)))) {
          row = i;
          column = k;
        }
      }
    }
    if (row < 0) break;
    row_used[static_cast<std::size_t>(row)] = column_used[static_cast<std::size_t>(column)] = true;
    for (Index k = 0; k < n; ++k) {
      if (column_used[static_cast<std::size_t>(k)] || a(row, k) == 0) continue;
      const double factor = a(row, k) / a(row, column);
      a.col(k) -= factor * a.col(column);
      r.col(k) -= factor * r.col(column);
      a(row, k) = 0;
    }
  }
  return r;
}

bool dominates(const Matrix& added, const Vector& weight) {
  constexpr double large = 1e3;
  for (Index k = 0; k < added.cols(); ++k) {
    for (Index i = 0; i < added.rows(); ++i) {
      if (std::abs(added(i, k)) > large * std::sqrt(weight(i) * weight(k))) return true;
    }
  }
  return false;
}

// What is below rounding of its terms is zero.
void drop_rounding(Matrix& a, const Matrix& terms) {
  const double zero = zero_to_rounding(terms.rows() + terms.cols());
  for (Index k = 0; k < a.cols(); ++k) {
    for (Index i = 0; i < a.rows(); ++i) {
      if (std::abs(a(i, k)) <= zero * terms(i, k)) a(i, k) = 0;
    }
  }
}

// One step: the system without the directions N₀; `terms` of its stiffness follow.
SingularSystem removed(const SingularSystem& s, Matrix n0, Matrix& terms, Deflation::Step& step) {
  const Index n = s.size();
  const std::vector<Index> pivots = pivots_of(n0);
  std::vector<Index> rest;
  Index split = s.split;
  for (Index i = 0; i < n; ++i) {
    if (std::find(pivots.begin(), pivots.end(), i) == pivots.end())
      rest.push_back(i);
    else if (s.split >= 0 && i < s.split)
      --split;
  }
  const Matrix m_n0 = multiply(s.mass, n0);
  const lapack::Cholesky m0(symmetric_part(multiply_tn(n0, m_n0)));
  Matrix a = multiply_tn(n0, s.gyroscopic)(Eigen::all, rest);
  drop_rounding(a, Matrix(n0.cwiseAbs().transpose() * entry_scale(s.gyroscopic))(Eigen::all, rest));
  const Matrix k_part = s.stiffness(rest, rest);
  Matrix e = Matrix::Zero(n, static_cast<Index>(rest.size()));
  for (std::size_t i = 0; i < rest.size(); ++i) e(rest[i], static_cast<Index>(i)) = 1;
  Matrix k = k_part;
  Matrix k_terms = terms(rest, rest);
  const Vector weight = own_weights(k_terms);
  if (dominates(a.transpose() * m0.solve(a), weight)) {
    const Matrix r = gathered(a, weight);
    e = multiply(e, r);
    k = congruence(r, k_part);
    k_terms = congruence(r.cwiseAbs(), k_terms);
  }
  step.n0 = n0;
  step.c = e - multiply(n0, m0.solve(multiply_tn(m_n0, e)));
  step.rates = m0.solve(a);
  const Matrix added = multiply_tn(a, step.rates);
  terms = k_terms + a.cwiseAbs().transpose() * step.rates.cwiseAbs();
  return {symmetric_part(congruence(step.c, s.mass)), skew_part(congruence(step.c, s.gyroscopic)), symmetric_part(k + added), split};
}

}  // namespace

Deflation deflate(SingularSystem system) {
  Deflation d;
  Matrix terms = entry_scale(system.stiffness);
  for (;;) {  // every turn but the last removes at least one coordinate
    const Null null = null_of(system, terms);
    const Split parts = split_null(system, null.vectors);
    d.doubtful = d.doubtful || null.doubtful || parts.doubtful;
    if (parts.n0.cols() == 0) {
      d.negative_first = null.negative_first;
      d.negative_second = null.negative_second;
      d.gyroscopic_null = parts.ng;
      d.zero_pairs += parts.ng.cols() / 2;
      break;
    }
    Deflation::Step step;
    d.zero_pairs += parts.n0.cols();
    d.ignorable += parts.n0.cols();
    system = removed(system, parts.n0, terms, step);
    d.steps.push_back(std::move(step));
    if (system.size() == 0) {
      d.gyroscopic_null.resize(0, 0);
      break;
    }
  }
  d.reduced = std::move(system);
  return d;
}

ComplexMatrix Deflation::expand(const ComplexMatrix& shapes, const ComplexVector& lambda) const {
  ComplexMatrix x = shapes;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    const ComplexMatrix a = -(step->rates * x) * lambda.cwiseInverse().asDiagonal();
    x = (step->c * x + step->n0 * a).eval();
  }
  return x;
}

}  // namespace gyromode::dense
