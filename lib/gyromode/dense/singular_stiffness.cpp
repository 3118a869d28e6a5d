#include "gyromode/dense/singular_stiffness.h"

#include "gyromode/dense/general/definite.h"
#include "gyromode/dense/general/indefinite.h"
#include "gyromode/dense/mass_normal.h"
#include "gyromode/dense/quadrature/quadrature.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/triangular.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace gyromode::dense {

namespace {

// f with k = f fᵀ for k ≥ 0 whose null space is spanned by the columns of `null`: f = C·chol(CᵀkC), C its complement.
// Empty where rounding leaves k indefinite there.
std::optional<Matrix> semidefinite_root(const Matrix& k, const Matrix& null) {
  const Index n = k.rows();
  const Matrix c = lapack::orthogonal_completion(null).rightCols(n - null.cols());
  Matrix l = lapack::multiply_tn(c, lapack::multiply(k, c));
  if (lapack::cholesky(l)) return std::nullopt;
  return lapack::multiply(c, l);
}

Matrix normal_null(const MassNormal& normal, Matrix null) {
  if (null.cols() > 0) normal.to_normal(null);
  return null;
}

// Shapes of the reduced system, all its vibrations.
ComplexMatrix solve_reduced_quadrature(const Deflation& d, Spectrum& s) {
  const SingularSystem& m = d.reduced;
  const Index p = m.split;
  const Index r = m.size() - p;
  const Index pairs = d.gyroscopic_null.cols() / 2;
  const MassNormal first(m.mass.topLeftCorner(p, p)), second(m.mass.bottomRightCorner(r, r));
  const auto block = [](const MassNormal& normal, const Matrix& stiffness, const Matrix& given_null, Index negative) {
    Matrix k = normal.stiffness(stiffness), null = normal_null(normal, given_null);
    std::optional<Matrix> root;
    if (negative == 0) root = semidefinite_root(k, null);
    StiffnessBlock made = root ? StiffnessBlock(std::move(k), std::move(*root)) : StiffnessBlock(std::move(k));
    made.set_null(std::move(null));
    made.ask_for({[&normal](MatrixSpan x) { normal.to_physical(x); }, {}});
    return made;
  };
  QuadratureModes modes = quadrature_modes(
      {first.coupling(m.gyroscopic.topRightCorner(p, r), second),
       block(first, m.stiffness.topLeftCorner(p, p), d.gyroscopic_null.topLeftCorner(p, pairs), d.negative_first),
       block(second, m.stiffness.bottomRightCorner(r, r), d.gyroscopic_null.bottomRightCorner(r, pairs), d.negative_second)});
  ComplexMatrix shapes(m.size(), modes.omega.size());
  shapes.topRows(p) = modes.x.cast<Complex>();
  shapes.bottomRows(r) = Complex(0, -1) * modes.y.cast<Complex>();
  s.solver = "quadrature: " + modes.solver;
  s.omega = std::move(modes.omega);
  s.unstable = std::move(modes.unstable);
  return shapes;
}

ComplexMatrix solve_reduced_general(const Deflation& d, Spectrum& s) {
  const MassNormal normal(d.reduced.mass);
  const Matrix gamma = normal.gyroscopic(d.reduced.gyroscopic);
  const Matrix k = normal.stiffness(d.reduced.stiffness);
  const Matrix null = normal_null(normal, d.gyroscopic_null);
  std::optional<Matrix> root;
  if (d.negative() == 0) root = semidefinite_root(k, null);
  ComplexMatrix shapes(d.reduced.size(), 0);
  if (root) {
    ComplexModes modes = definite_modes(gamma, *root);
    s.omega = std::move(modes.omega);
    shapes.resize(d.reduced.size(), s.omega.size());
    shapes.real() = modes.re;
    shapes.imag() = modes.im;
    s.solver = "general, K ≥ 0: singular values of a real bidiagonal matrix from a skew tridiagonal form";
  } else {
    IndefiniteModes modes = indefinite_modes({gamma, k}, null);
    shapes = std::move(modes.shapes);
    s.omega = std::move(modes.omega);
    s.unstable = std::move(modes.unstable);
    normal.to_physical(s.unstable);
    s.solver = "general, K indefinite: eigenvalues of order 2n with the Hamiltonian pairing kept";
  }
  normal.to_physical(shapes);
  return shapes;
}

ComplexVector as_vector(const std::vector<Complex>& lambda) {
  return Eigen::Map<const ComplexVector>(lambda.data(), static_cast<Index>(lambda.size()));
}

}  // namespace

void store_zero_modes(const Deflation& d, const Matrix& null_space, Spectrum& s) {
  s.reduced_negative = d.negative();
  s.impedance_negative = d.ignorable + d.negative() + d.gyroscopic_null.cols() / 2;
  s.rank_doubtful = s.rank_doubtful || d.doubtful;
  s.zero_shapes.resize(null_space.rows(), d.zero_pairs);
  for (Index k = 0; k < d.zero_pairs; ++k) s.zero_shapes.col(k) = null_space.col(std::min(k, null_space.cols() - 1));
}

void solve_singular_stiffness(SingularSystem system, const Matrix& null_space, Spectrum& s) {
  const Index split = system.split;
  const Deflation d = deflate(std::move(system));
  store_zero_modes(d, null_space, s);
  s.omega.resize(0);
  ComplexMatrix shapes(d.reduced.size(), 0);
  if (d.reduced.size() > 0) shapes = split < 0 ? solve_reduced_general(d, s) : solve_reduced_quadrature(d, s);
  const ComplexMatrix z = d.expand(shapes, Complex(0, 1) * s.omega.cast<Complex>());
  if (s.unstable.count() > 0) {
    const ComplexVector lambda = as_vector(s.unstable.lambda);
    s.unstable.right = d.expand(s.unstable.right, lambda);
    s.unstable.left = d.expand(s.unstable.left, -lambda.conjugate());
  }
  if (split < 0) {
    s.re = z.real();
    s.im = z.imag();
  } else {
    s.re = z.topRows(split).real();
    s.im = z.bottomRows(z.rows() - split).imag();
  }
  s.solver += fmt::format("; {} zero mode{} taken out first", d.zero_pairs, d.zero_pairs == 1 ? "" : "s");
  if (s.omega.size() == 0 && d.reduced.size() == 0) s.solver = "every coordinate is ignorable: zero modes only";
}

}  // namespace gyromode::dense
