#include "gyromode/dense/general/definite.h"
#include "gyromode/base/rounding.h"
#include "gyromode/dense/mass_normal.h"
#include "gyromode/dense/second_order.h"
#include "gyromode/lapack/singular.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/structure/inertia_of_k.h"

namespace gyromode::dense {

namespace {

double rank_threshold(Index n, double largest) { return zero_to_rounding(n) * largest; }

// X = (L₁⁻ᵀa, −jL₂⁻ᵀc) for the singular vectors a, c of L₁⁻¹BL₂⁻ᵀ; the constant solutions are the null spaces of Bᵀ and
// B.
void solve_partitioned(const Impedance& h, Spectrum& s) {
  const MassNormal first(h.mass_rr());
  const MassNormal second(h.mass_ii());
  const auto svd = lapack::singular_value_decomposition(first.coupling(h.gyroscopic_ri(), second));
  const double largest = svd.values.size() > 0 ? svd.values(0) : 0;
  const Index m = (svd.values.array() > rank_threshold(h.size(), largest)).count();
  s.omega = svd.values.head(m).reverse();
  s.re = svd.u.leftCols(m).rowwise().reverse();
  s.im = -svd.vt.topRows(m).colwise().reverse().transpose();
  first.to_physical(s.re);
  second.to_physical(s.im);
  s.solver = "first order, quadrature: singular values of L₁⁻¹BL₂⁻ᵀ (real, p × r)";
}

void solve_whole(const Matrix& inertia, const Matrix& g, Spectrum& s) {
  const MassNormal normal(inertia);
  const Matrix skew = normal.gyroscopic(g);
  ComplexModes modes = skew_modes(skew, rank_threshold(skew.rows(), skew.norm()));
  s.omega = std::move(modes.omega);
  s.re = std::move(modes.re);
  s.im = std::move(modes.im);
  normal.to_physical(s.re);
  normal.to_physical(s.im);
  s.solver = "first order, general: singular values of a real bidiagonal matrix from the skew tridiagonal form of L⁻¹GL⁻ᵀ";
}

// An orthonormal basis of null(G), of the dimension that the count of modes leaves: the smallest eigenvalues of GᵀG.
Matrix constant_solutions(const Matrix& g, Index count) {
  if (count == 0) return Matrix(g.rows(), 0);
  return lapack::singular_value_decomposition(g).vt.bottomRows(count).transpose();
}

}  // namespace

void solve_first_order(const Impedance& h, Spectrum& s) {
  Matrix g = h.gyroscopic_ri();
  if (h.quadrature()) {
    solve_partitioned(h, s);
    const Index p = h.mass_rr().rows();
    g = Matrix::Zero(h.size(), h.size());
    g.topRightCorner(p, h.size() - p) = h.gyroscopic_ri();
    g.bottomLeftCorner(h.size() - p, p) = -h.gyroscopic_ri().transpose();
  } else {
    solve_whole(h.mass_rr(), g, s);
  }
  s.zero_shapes = constant_solutions(g, h.size() - 2 * s.omega.size());
}

}  // namespace gyromode::dense
