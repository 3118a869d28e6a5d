#include "gyromode/dense/basis.h"
#include "gyromode/base/rounding.h"
#include "gyromode/dense/second_order.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/singular.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/structure/inertia_of_k.h"
#include "gyromode/structure/ranked_skew.h"
#include "gyromode/system/laws.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gyromode::dense {

namespace {

// One group in orthogonal coordinates whose last ones span its part of null(K): k with rows of exact zeros there.
// Rounding of the change of coordinates cannot make a null space of its own.
struct Group {
  Matrix basis;  // in_phase or in_quadrature in these coordinates
  Matrix turn;   // Q
  Matrix k;
  StiffnessInertia d;
};

Group with_null_space(const Matrix& basis, const Matrix& k, const Matrix& null) {
  const Index n = k.rows(), zero = null.cols();
  const Matrix completed = lapack::orthogonal_completion(null);
  Group g{{}, Matrix(n, n), {}, {}};
  g.turn << completed.rightCols(n - zero), completed.leftCols(zero);
  g.basis = lapack::multiply(basis, g.turn);
  g.k = symmetric_part(lapack::multiply_tn(g.turn, lapack::multiply(k, g.turn)));
  g.k.rightCols(zero).setZero();
  g.k.bottomRows(zero).setZero();
  const Vector values = lapack::symmetric_eigenvalues(g.k.topLeftCorner(n - zero, n - zero));
  g.d.negative = (values.array() < 0).count();
  g.d.positive = n - zero - g.d.negative;
  g.d.zero = zero;
  g.d.null_space = Matrix::Identity(n, n).rightCols(zero);
  return g;
}

// b in the coordinates of the groups. What it makes of the two null spaces is NᵀGN of the given matrices, whose rank is
// decided there, by the terms of its entries; no value where the entries here have another one.
std::optional<Matrix> turned_coupling(const SecondOrder& m, const Matrix& null, const Matrix& b, const Group& one, const Group& two) {
  Matrix turned = lapack::multiply_tn(one.turn, lapack::multiply(b, two.turn));
  auto corner = turned.bottomRightCorner(one.d.zero, two.d.zero);
  if (corner.size() == 0) return turned;
  const double many = zero_to_rounding(m.size());
  const Matrix terms =
      one.basis.rightCols(one.d.zero).cwiseAbs().transpose() * entry_scale(m.gyroscopic) * two.basis.rightCols(two.d.zero).cwiseAbs();
  corner = (corner.array().abs() <= many * terms.array()).select(0, corner).eval();
  const RankedSkew given = ranked_skew_on(m.gyroscopic, null);
  const Vector values = lapack::singular_value_decomposition(corner).values;
  const Index rank = (values.array() > many * terms.maxCoeff()).count();
  return 2 * rank == static_cast<Index>(given.regular.size()) ? std::optional(turned) : std::nullopt;
}

// null(K) falls into its parts in the two groups: the singular values of an orthonormal basis restricted to the first
// are 1 and 0.
struct SplitNull {
  Matrix first, second;
};
SplitNull split_null(const Matrix& null, Index p) {
  const Matrix basis = orthonormal_basis(null);
  const auto top = lapack::singular_value_decomposition(basis.topRows(p));
  const auto bottom = lapack::singular_value_decomposition(basis.bottomRows(basis.rows() - p));
  const auto ones = [](const Vector& values) { return (values.array() > std::sqrt(0.5)).count(); };
  return {top.u.leftCols(ones(top.values)), bottom.u.leftCols(ones(bottom.values))};
}

}  // namespace

bool solve_second_order(const SecondOrder& m, const ReversingSymmetry& r, Spectrum& s) {
  const Index p = r.in_phase.cols();
  const Index q = r.in_quadrature.cols();
  const StiffnessInertia d = inertia_of_k(m.stiffness);
  SplitNull null{Matrix(p, 0), Matrix(q, 0)};
  if (d.zero > 0) {
    Matrix whole(m.size(), p + q);
    whole << r.in_phase, r.in_quadrature;
    null = split_null(lapack::multiply_tn(whole, lapack::multiply(m.mass, d.null_space)), p);
  }
  const Group one = with_null_space(r.in_phase, r.stiffness1, null.first),
              two = with_null_space(r.in_quadrature, r.stiffness2, null.second);
  if (one.d.negative + two.d.negative != d.negative || one.d.zero + two.d.zero != d.zero) return false;

  const auto coupling = turned_coupling(m, d.null_space, r.coupling, one, two);
  if (!coupling) return false;

  s.split = p;
  solve_second_order(SecondOrderQuadrature{Matrix::Identity(p, p), Matrix::Identity(q, q), *coupling, one.k, two.k}, one.d, two.d, s);
  s.split = -1;
  s.stiffness_margin = d.margin;
  s.rank_doubtful = d.doubtful;
  s.re = lapack::multiply(one.basis, s.re);
  s.im = lapack::multiply(two.basis, s.im);
  Matrix to_physical(m.size(), p + q);
  to_physical << one.basis, two.basis;
  s.zero_shapes = lapack::multiply(to_physical, s.zero_shapes);
  if (s.unstable.count() > 0) {
    s.unstable.right = (to_physical.cast<Complex>() * s.unstable.right).eval();
    s.unstable.left = (to_physical.cast<Complex>() * s.unstable.left).eval();
  }
  s.solver = "hidden " + s.solver;
  return true;
}

}  // namespace gyromode::dense
