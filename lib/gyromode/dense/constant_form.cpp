#include "gyromode/dense/constant_form.h"

#include "gyromode/base/error.h"
#include "gyromode/dense/mass_normal.h"
#include "gyromode/dense/general/skew_tridiagonal.h"
#include "gyromode/spectrum/spectrum.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/reflectors.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/structure/inertia_of_k.h"
#include "gyromode/structure/reversing_symmetry.h"

namespace gyromode::dense {

namespace {

// One component in coordinates of its own.
struct Form {
  Matrix w, displacement, velocity;
  std::optional<Matrix> orthogonal, bidiagonal;
  std::string solver;
};

// A square f with k = f fᵀ for k ≥ 0 with `zero` zero eigenvalues: exactly zero columns for them.
Matrix square_root(const Matrix& k, Index zero) {
  auto e = lapack::symmetric_eigen(k);
  e.values.head(zero).setZero();
  return e.vectors * e.values.cwiseMax(0).cwiseSqrt().asDiagonal();
}

// ẍ + bẏ + k₁x = 0, ÿ − bᵀẋ + k₂y = 0 with k₁ = f fᵀ: u = (fᵀx, ẏ), in normal coordinates x = to_x q, y = to_y q.
Form from_groups(const Matrix& f, const Matrix& b, const Matrix& k2, const Matrix& to_x, const Matrix& to_y) {
  const Index p = b.rows(), r = b.cols(), n = p + r;
  Form form;
  form.w.resize(n, n);
  form.w.topLeftCorner(p, p) = lapack::gram(f);
  form.w.topRightCorner(p, r) = lapack::multiply_tn(f, b);
  form.w.bottomLeftCorner(r, p) = form.w.topRightCorner(p, r).transpose();
  form.w.bottomRightCorner(r, r) = lapack::gram(b) + k2;
  form.displacement = Matrix::Zero(n, n);
  form.velocity = Matrix::Zero(n, n);
  form.displacement.topRows(p) = lapack::multiply_tn(f, to_x);
  form.velocity.bottomRows(r) = to_y;
  return form;
}

struct PhaseGroups {
  Matrix k1, k2, b, to_x, to_y;
  StiffnessInertia d1, d2;
};

Form by_groups(PhaseGroups g) {
  if (g.d1.negative > 0) {  // the groups exchanged: b → −bᵀ
    std::swap(g.k1, g.k2);
    std::swap(g.d1, g.d2);
    std::swap(g.to_x, g.to_y);
    g.b = (-g.b.transpose()).eval();
  }
  if (g.d1.negative > 0) {
    throw NotApplicable(
        "K is indefinite in both groups of the partition: the real n × n matrix of such a system, P of docs/theory.md, is not symmetric");
  }
  Form form = from_groups(square_root(g.k1, g.d1.zero), g.b, g.k2, g.to_x, g.to_y);
  form.solver = "W = [fᵀf fᵀb; bᵀf bᵀb + k₂]";
  return form;
}

Matrix normal_coordinates(const MassNormal& normal) {
  Matrix to = Matrix::Identity(normal.size(), normal.size());
  normal.to_normal(to);
  return to;
}

Form by_tridiagonal(const Matrix& mass, const Matrix& gyroscopic, const Matrix& stiffness) {
  const StiffnessInertia d = inertia_of_k(stiffness);
  if (d.negative > 0)
    throw NotApplicable(
        "K is indefinite, and so is the stiffness of both groups of a quadrature partition, if there is one: a constant real symmetric "
        "matrix of order n with eigenvalues ω² is known for K ≥ 0 only");
  const Index n = mass.rows();
  const MassNormal normal(mass);
  const Matrix f = square_root(normal.stiffness(stiffness), d.zero);
  Matrix z = Matrix::Zero(2 * n, 2 * n);
  z.bottomLeftCorner(n, n) = -f;
  z.bottomRightCorner(n, n) = -normal.gyroscopic(gyroscopic);
  const SkewTridiagonal t(std::move(z));
  Form form;
  // Rows 0, 2, … and columns 1, 3, … of T: T(k+1, k) = β_k, T(k, k+1) = −β_k.
  Matrix bidiagonal = Matrix::Zero(n, n);
  for (Index i = 0; i < n; ++i) {
    bidiagonal(i, i) = -t.subdiagonal()(2 * i);
    if (i + 1 < n) bidiagonal(i + 1, i) = t.subdiagonal()(2 * i + 1);
  }
  form.w = lapack::gram(bidiagonal);
  Matrix q = Matrix::Identity(2 * n, 2 * n);
  lapack::multiply_right(q, t.q());
  // z = (fᵀ x, ẋ), x = to_x q; the even positions of Qᵀz obey ü = −DᵀD u.
  const Matrix to_x = normal_coordinates(normal);
  Matrix even(n, 2 * n);
  for (Index i = 0; i < n; ++i) even.row(i) = q.col(2 * i + 1).transpose();
  form.displacement = lapack::multiply(even.leftCols(n), lapack::multiply_tn(f, to_x));
  form.velocity = lapack::multiply(even.rightCols(n), to_x);
  form.orthogonal = std::move(q);
  form.bidiagonal = std::move(bidiagonal);
  form.solver = "W = DᵀD, tridiagonal, D the bidiagonal half of the skew tridiagonal form of order 2n";
  return form;
}

Form of_partition(const System& s, const Component& c) {
  const auto& one = c.in_phase;
  const auto& two = c.in_quadrature;
  const MassNormal first(s.mass()(one, one)), second(s.mass()(two, two));
  const Index n = static_cast<Index>(one.size() + two.size());
  Matrix to_x = Matrix::Zero(static_cast<Index>(one.size()), n), to_y = Matrix::Zero(static_cast<Index>(two.size()), n);
  to_x.leftCols(to_x.rows()) = normal_coordinates(first);
  to_y.rightCols(to_y.rows()) = normal_coordinates(second);
  const Matrix k1 = s.stiffness()(one, one), k2 = s.stiffness()(two, two);
  return by_groups({first.stiffness(k1), second.stiffness(k2), first.coupling(s.gyroscopic()(one, two), second), to_x, to_y,
                    inertia_of_k(k1), inertia_of_k(k2)});
}

// A whole K ≥ 0 may be more than its parts by a symmetry show through rounding: then the general form serves.
Form of_symmetry(const System& s, const Component& c) {
  const auto& at = c.coordinates;
  const ReversingSymmetry& r = *c.search->found;
  const Matrix mass = s.mass()(at, at);
  StiffnessInertia d1 = inertia_of_k(r.stiffness1), d2 = inertia_of_k(r.stiffness2);
  if (d1.negative > 0 && d2.negative > 0) return by_tridiagonal(mass, s.gyroscopic()(at, at), s.stiffness()(at, at));
  return by_groups({r.stiffness1, r.stiffness2, r.coupling, lapack::multiply_tn(r.in_phase, mass),
                    lapack::multiply_tn(r.in_quadrature, mass), std::move(d1), std::move(d2)});
}

std::vector<Index> order_of(const Component& c) {
  if (!c.quadrature()) return c.coordinates;
  std::vector<Index> order = c.in_phase;
  order.insert(order.end(), c.in_quadrature.begin(), c.in_quadrature.end());
  return order;
}

}  // namespace

ConstantForm constant_form(const System& s, const Structure& structure) {
  const Index n = s.size();
  ConstantForm whole{Matrix::Zero(n, n), Matrix::Zero(n, n), Matrix::Zero(n, n), std::nullopt, std::nullopt, ""};
  Index row = 0;
  for (const Component& c : structure.components) {
    const auto& at = c.coordinates;
    Form form = c.quadrature()          ? of_partition(s, c)
                : c.hidden_quadrature() ? of_symmetry(s, c)
                                        : by_tridiagonal(s.mass()(at, at), s.gyroscopic()(at, at), s.stiffness()(at, at));
    const std::vector<Index> order = order_of(c);
    const Index size = form.w.rows();
    whole.w.block(row, row, size, size) = form.w;
    whole.displacement.middleRows(row, size)(Eigen::all, order) = form.displacement;
    whole.velocity.middleRows(row, size)(Eigen::all, order) = form.velocity;
    if (size == n) {
      whole.orthogonal = std::move(form.orthogonal);
      whole.bidiagonal = std::move(form.bidiagonal);
    }
    if (whole.solver.find(form.solver) == std::string::npos) whole.solver += (whole.solver.empty() ? "" : "; ") + form.solver;
    row += size;
  }
  return whole;
}

}  // namespace gyromode::dense
