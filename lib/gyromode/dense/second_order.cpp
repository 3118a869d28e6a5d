#include "gyromode/dense/second_order.h"

#include "gyromode/dense/definite.h"
#include "gyromode/dense/ignorable.h"
#include "gyromode/dense/indefinite.h"
#include "gyromode/dense/mass_normal.h"
#include "gyromode/dense/quadrature.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/status.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/structure/definiteness.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace gyromode::dense {

namespace {

// f with k = f fᵀ for k ≥ 0 whose null space is spanned by the orthonormal columns of `null`: f = C·chol(CᵀkC), C its complement.
Matrix semidefinite_root(const Matrix& k, const Matrix& null) {
  const Index n = k.rows();
  const Matrix c = lapack::orthogonal_completion(null).rightCols(n - null.cols());
  Matrix l = lapack::multiply_tn(c, lapack::multiply(k, c));
  if (lapack::cholesky(l)) throw lapack::Failure("a semidefinite stiffness has no Cholesky factor beside its null space");
  return lapack::multiply(c, l);
}

// Everything but the undamped shapes, which the caller turns back to physical coordinates; so it does with the flutter shapes.
template <class Modes>
void store_roots(Modes& modes, Spectrum& s) {
  s.omega = std::move(modes.omega);
  s.divergence = std::move(modes.divergence);
  s.flutter = std::move(modes.flutter);
  s.flutter_shapes = std::move(modes.flutter_shapes);
}

// ---- K regular -------------------------------------------------------------------------------------------------------

void solve_regular_quadrature(const SecondOrder& m, const Definiteness& d1, const Definiteness& d2, Spectrum& s) {
  const Index p = m.split;
  const Index r = m.size() - p;
  const MassNormal first(m.mass.topLeftCorner(p, p));
  const MassNormal second(m.mass.bottomRightCorner(r, r));
  const Matrix k1 = m.stiffness.topLeftCorner(p, p);
  const Matrix k2 = m.stiffness.bottomRightCorner(r, r);
  QuadratureForm form{first.coupling(m.gyroscopic.topRightCorner(p, r), second), first.stiffness(k1), second.stiffness(k2), {}, {}, {}, {}};
  if (d1.negative == 0) form.f1 = first.stiffness_root(k1);
  if (d2.negative == 0) form.f2 = second.stiffness_root(k2);
  QuadratureModes modes = quadrature_modes(form);
  first.to_physical(modes.x);
  second.to_physical(modes.y);
  s.re = std::move(modes.x);
  s.im = -modes.y;
  s.path = "quadrature: " + modes.path;
  store_roots(modes, s);
  if (s.flutter_shapes.cols() > 0) {
    ComplexMatrix x = s.flutter_shapes.topRows(p);
    ComplexMatrix y = s.flutter_shapes.bottomRows(r);
    first.to_physical(x);
    second.to_physical(y);
    s.flutter_shapes << x, y;
  }
}

void solve_regular_general(const SecondOrder& m, const Definiteness& d, Spectrum& s) {
  const MassNormal normal(m.mass);
  const Matrix gamma = normal.gyroscopic(m.gyroscopic);
  if (d.negative == 0) {
    ComplexModes modes = definite_modes(gamma, normal.stiffness_root(m.stiffness));
    s.omega = std::move(modes.omega);
    s.re = std::move(modes.re);
    s.im = std::move(modes.im);
    s.path = "general, K > 0: singular values of a real bidiagonal n × n matrix from the skew tridiagonal form of order 2n";
  } else {
    IndefiniteModes modes = indefinite_modes({gamma, normal.stiffness(m.stiffness)}, Matrix(m.size(), 0));
    s.re = modes.shapes.real();
    s.im = modes.shapes.imag();
    store_roots(modes, s);
    normal.to_physical(s.flutter_shapes);
    s.path = fmt::format("general, K indefinite ({} negative): eigenvalues of order 2n with the Hamiltonian pairing kept", d.negative);
  }
  normal.to_physical(s.re);
  normal.to_physical(s.im);
}

// ---- K singular: ignorable coordinates first -----------------------------------------------------------------------------

NormalForm normal_form(const SecondOrder& m) {
  const Index n = m.size();
  if (m.split < 0) {
    const MassNormal normal(m.mass);
    return {normal.gyroscopic(m.gyroscopic), normal.stiffness(m.stiffness), -1};
  }
  const Index p = m.split;
  const Index r = n - p;
  const MassNormal first(m.mass.topLeftCorner(p, p));
  const MassNormal second(m.mass.bottomRightCorner(r, r));
  NormalForm form{Matrix::Zero(n, n), Matrix::Zero(n, n), p};
  const Matrix b = first.coupling(m.gyroscopic.topRightCorner(p, r), second);
  form.gamma.topRightCorner(p, r) = b;
  form.gamma.bottomLeftCorner(r, p) = -b.transpose();
  form.k.topLeftCorner(p, p) = first.stiffness(m.stiffness.topLeftCorner(p, p));
  form.k.bottomRightCorner(r, r) = second.stiffness(m.stiffness.bottomRightCorner(r, r));
  return form;
}

// Shapes of the reduced system, all its vibrations.
ComplexMatrix solve_reduced_quadrature(const Deflation& d, Spectrum& s) {
  const Index p = d.reduced.split;
  const Index r = d.reduced.size() - p;
  const Index pairs = d.gyroscopic_null.cols() / 2;
  QuadratureForm form{d.reduced.gamma.topRightCorner(p, r), d.reduced.k.topLeftCorner(p, p), d.reduced.k.bottomRightCorner(r, r), {}, {},
                      d.gyroscopic_null.topLeftCorner(p, pairs), d.gyroscopic_null.bottomRightCorner(r, pairs)};
  if (d.negative_in(form.k1) == 0) form.f1 = semidefinite_root(form.k1, form.null1);
  if (d.negative_in(form.k2) == 0) form.f2 = semidefinite_root(form.k2, form.null2);
  QuadratureModes modes = quadrature_modes(form);
  ComplexMatrix shapes(d.reduced.size(), modes.omega.size());
  shapes.topRows(p) = modes.x.cast<Complex>();
  shapes.bottomRows(r) = Complex(0, -1) * modes.y.cast<Complex>();
  s.path = "quadrature: " + modes.path;
  store_roots(modes, s);
  return shapes;
}

ComplexMatrix solve_reduced_general(const Deflation& d, Spectrum& s) {
  ComplexMatrix shapes(d.reduced.size(), 0);
  if (d.negative == 0) {
    ComplexModes modes = definite_modes(d.reduced.gamma, semidefinite_root(d.reduced.k, d.gyroscopic_null));
    s.omega = std::move(modes.omega);
    shapes.resize(d.reduced.size(), s.omega.size());
    shapes.real() = modes.re;
    shapes.imag() = modes.im;
    s.path = "general, K ≥ 0: singular values of a real bidiagonal matrix from a skew tridiagonal form";
  } else {
    IndefiniteModes modes = indefinite_modes(d.reduced, d.gyroscopic_null);
    shapes = std::move(modes.shapes);
    store_roots(modes, s);
    s.path = "general, K indefinite: eigenvalues of order 2n with the Hamiltonian pairing kept";
  }
  return shapes;
}

// Complex shapes of all rows, group by group.
void to_physical(const SecondOrder& m, ComplexMatrix& x) {
  if (m.split < 0) return MassNormal(m.mass).to_physical(x);
  const Index r = m.size() - m.split;
  ComplexMatrix first = x.topRows(m.split);
  ComplexMatrix second = x.bottomRows(r);
  MassNormal(m.mass.topLeftCorner(m.split, m.split)).to_physical(first);
  MassNormal(m.mass.bottomRightCorner(r, r)).to_physical(second);
  x << first, second;
}

// q to z, group by group.
Matrix to_normal(const SecondOrder& m, Matrix q) {
  if (m.split < 0) {
    MassNormal(m.mass).to_normal(q);
    return q;
  }
  const Index r = m.size() - m.split;
  MassNormal(m.mass.topLeftCorner(m.split, m.split)).to_normal(q.topRows(m.split));
  MassNormal(m.mass.bottomRightCorner(r, r)).to_normal(q.bottomRows(r));
  return q;
}

void solve_singular(const SecondOrder& m, const Matrix& null_space, Index null_in_first, Spectrum& s) {
  const Deflation d = deflate(normal_form(m), {to_normal(m, null_space), null_in_first, s.stiffness_negative, null_error(m.size(), s.stiffness_margin)});
  store_zero_modes(d, null_space, s);
  s.omega.resize(0);
  ComplexMatrix shapes(d.reduced.size(), 0);
  if (d.reduced.size() > 0) shapes = m.split < 0 ? solve_reduced_general(d, s) : solve_reduced_quadrature(d, s);
  ComplexMatrix z = d.expand(shapes, Complex(0, 1) * s.omega.cast<Complex>());
  to_physical(m, z);
  if (!s.flutter.empty()) {
    s.flutter_shapes = d.expand(s.flutter_shapes, Eigen::Map<const ComplexVector>(s.flutter.data(), static_cast<Index>(s.flutter.size())));
    to_physical(m, s.flutter_shapes);
  }
  if (m.split < 0) {
    s.re = z.real();
    s.im = z.imag();
  } else {
    s.re = z.topRows(m.split).real();
    s.im = z.bottomRows(m.size() - m.split).imag();
  }
  s.path += fmt::format("; {} zero mode{} taken out first", d.zero_pairs, d.zero_pairs == 1 ? "" : "s");
  if (s.omega.size() == 0 && d.reduced.size() == 0) s.path = "every coordinate is ignorable: zero modes only";
}

// Definiteness of K, block by block where there is a partition.
std::pair<Definiteness, Definiteness> stiffness_blocks(const SecondOrder& m) {
  if (m.split < 0) return {definiteness(m.stiffness), Definiteness{}};
  const Index r = m.size() - m.split;
  return {definiteness(m.stiffness.topLeftCorner(m.split, m.split)), definiteness(m.stiffness.bottomRightCorner(r, r))};
}

}  // namespace

double null_error(Index n, double margin) { return 64 * static_cast<double>(n) * std::numeric_limits<double>::epsilon() / std::max(margin, 1e-8); }

void store_zero_modes(const Deflation& d, const Matrix& null_space, Spectrum& s) {
  s.reduced_negative = d.negative;
  s.impedance_negative = d.ignorable + d.negative + d.gyroscopic_null.cols() / 2;
  s.zero_shapes.resize(null_space.rows(), d.zero_pairs);
  for (Index k = 0; k < d.zero_pairs; ++k) s.zero_shapes.col(k) = null_space.col(std::min(k, null_space.cols() - 1));
}

void solve_second_order(const SecondOrder& m, Spectrum& s) {
  const auto [d1, d2] = stiffness_blocks(m);
  s.stiffness_negative = d1.negative + d2.negative;
  s.stiffness_zero = d1.zero + d2.zero;
  s.stiffness_margin = std::min(d1.margin, d2.margin);
  s.reduced_negative = s.impedance_negative = s.stiffness_negative;
  s.zero_shapes.resize(m.size(), 0);
  if (s.stiffness_zero > 0) {
    Matrix null_space = Matrix::Zero(m.size(), s.stiffness_zero);
    null_space.topLeftCorner(d1.null_space.rows(), d1.zero) = d1.null_space;
    if (d2.zero > 0) null_space.bottomRightCorner(d2.null_space.rows(), d2.zero) = d2.null_space;
    solve_singular(m, null_space, d1.zero, s);
  } else if (m.split >= 0) {
    solve_regular_quadrature(m, d1, d2, s);
  } else {
    solve_regular_general(m, d1, s);
  }
}

}  // namespace gyromode::dense
