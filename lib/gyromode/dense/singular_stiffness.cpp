#include "gyromode/dense/singular_stiffness.h"

#include "gyromode/dense/definite.h"
#include "gyromode/dense/indefinite.h"
#include "gyromode/dense/quadrature.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/status.h"
#include "gyromode/lapack/triangular.h"

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

// Shapes of the reduced system, all its vibrations.
ComplexMatrix solve_reduced_quadrature(const Deflation& d, Spectrum& s) {
  const Index p = d.reduced.split;
  const Index r = d.reduced.size() - p;
  const Index pairs = d.gyroscopic_null.cols() / 2;
  const auto block = [&](const Matrix& k, Matrix null) {
    StiffnessBlock made = d.negative_in(k) == 0 ? StiffnessBlock(k, semidefinite_root(k, null)) : StiffnessBlock(k);
    made.set_null(std::move(null));
    return made;
  };
  QuadratureModes modes = quadrature_modes({d.reduced.gamma.topRightCorner(p, r), block(d.reduced.k.topLeftCorner(p, p), d.gyroscopic_null.topLeftCorner(p, pairs)),
                                            block(d.reduced.k.bottomRightCorner(r, r), d.gyroscopic_null.bottomRightCorner(r, pairs))});
  ComplexMatrix shapes(d.reduced.size(), modes.omega.size());
  shapes.topRows(p) = modes.x.cast<Complex>();
  shapes.bottomRows(r) = Complex(0, -1) * modes.y.cast<Complex>();
  s.path = "quadrature: " + modes.path;
  s.store_roots(modes);
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
    s.store_roots(modes);
    s.path = "general, K indefinite: eigenvalues of order 2n with the Hamiltonian pairing kept";
  }
  return shapes;
}

}  // namespace

double null_error(Index n, double margin) { return 64 * static_cast<double>(n) * std::numeric_limits<double>::epsilon() / std::max(margin, 1e-8); }

void store_zero_modes(const Deflation& d, const Matrix& null_space, Spectrum& s) {
  s.reduced_negative = d.negative;
  s.impedance_negative = d.ignorable + d.negative + d.gyroscopic_null.cols() / 2;
  s.zero_shapes.resize(null_space.rows(), d.zero_pairs);
  for (Index k = 0; k < d.zero_pairs; ++k) s.zero_shapes.col(k) = null_space.col(std::min(k, null_space.cols() - 1));
}

void solve_singular_stiffness(NormalForm form, const MassNormalGroups& normal, const Matrix& null_space, Index null_in_first, Spectrum& s) {
  const Index split = form.split;
  Matrix null = null_space;
  normal.to_normal(null);
  const double error = null_error(form.size(), s.stiffness_margin);
  const Deflation d = deflate(std::move(form), {std::move(null), null_in_first, s.stiffness_negative, error});
  store_zero_modes(d, null_space, s);
  s.omega.resize(0);
  ComplexMatrix shapes(d.reduced.size(), 0);
  if (d.reduced.size() > 0) shapes = split < 0 ? solve_reduced_general(d, s) : solve_reduced_quadrature(d, s);
  ComplexMatrix z = d.expand(shapes, Complex(0, 1) * s.omega.cast<Complex>());
  normal.to_physical(z);
  if (!s.flutter.empty()) {
    s.flutter_shapes = d.expand(s.flutter_shapes, Eigen::Map<const ComplexVector>(s.flutter.data(), static_cast<Index>(s.flutter.size())));
    normal.to_physical(s.flutter_shapes);
  }
  if (split < 0) {
    s.re = z.real();
    s.im = z.imag();
  } else {
    s.re = z.topRows(split).real();
    s.im = z.bottomRows(z.rows() - split).imag();
  }
  s.path += fmt::format("; {} zero mode{} taken out first", d.zero_pairs, d.zero_pairs == 1 ? "" : "s");
  if (s.omega.size() == 0 && d.reduced.size() == 0) s.path = "every coordinate is ignorable: zero modes only";
}

}  // namespace gyromode::dense
