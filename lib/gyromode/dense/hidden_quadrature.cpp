#include "gyromode/dense/basis.h"
#include "gyromode/dense/second_order.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/singular.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/structure/definiteness.h"

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

namespace {

// Of one group's stiffness, whose null space is known: the eigenvalues of least modulus belong to it, the signs of the others count.
Definiteness with_null_space(const Matrix& k, Matrix null) {
  Definiteness d;
  d.zero = null.cols();
  d.null_space = std::move(null);
  Vector values = lapack::symmetric_eigenvalues(k);
  std::sort(values.begin(), values.end(), [](double a, double b) { return std::abs(a) > std::abs(b); });
  const Vector rest = values.head(values.size() - d.zero);
  d.negative = (rest.array() < 0).count();
  d.positive = rest.size() - d.negative;
  return d;
}

// null(K) falls into its parts in the two groups: the singular values of an orthonormal basis restricted to the first are 1 and 0.
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
  Matrix to_physical(m.size(), p + q);
  to_physical << r.in_phase, r.in_quadrature;
  const Definiteness d = definiteness(m.stiffness);
  SplitNull null{Matrix(p, 0), Matrix(q, 0)};
  if (d.zero > 0) null = split_null(lapack::multiply_tn(to_physical, lapack::multiply(m.mass, d.null_space)), p);
  const Definiteness d1 = with_null_space(r.stiffness1, std::move(null.first));
  const Definiteness d2 = with_null_space(r.stiffness2, std::move(null.second));
  if (d1.negative + d2.negative != d.negative || d1.zero + d2.zero != d.zero) return false;

  s.split = p;
  solve_second_order(SecondOrderQuadrature{Matrix::Identity(p, p), Matrix::Identity(q, q), r.coupling, r.stiffness1, r.stiffness2}, d1, d2, s);
  s.split = -1;
  s.stiffness_margin = d.margin;
  s.re = lapack::multiply(r.in_phase, s.re);
  s.im = lapack::multiply(r.in_quadrature, s.im);
  s.zero_shapes = lapack::multiply(to_physical, s.zero_shapes);
  if (s.flutter_shapes.cols() > 0) s.flutter_shapes = (to_physical.cast<Complex>() * s.flutter_shapes).eval();
  s.path = "hidden " + s.path;
  return true;
}

}  // namespace gyromode::dense
