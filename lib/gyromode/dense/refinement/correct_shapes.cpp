#include "gyromode/dense/refinement/correct_shapes.h"

#include "gyromode/lapack/multiply.h"

#include <cmath>

namespace gyromode::dense {

namespace {

// Roots with right and left vectors and s_k: modes jω, then λ and −λ̄ of every unstable one. Their conjugates are the
// other half.
struct Roots {
  ComplexVector lambda, slope;
  ComplexMatrix right, left;
};

Roots all_roots(const Impedance& h, const Spectrum& s) {
  const Index n = s.size(), m = s.omega.size(), u = s.unstable.count();
  Roots r{ComplexVector(m + 2 * u), ComplexVector(m + 2 * u), ComplexMatrix(n, m + 2 * u), ComplexMatrix(n, m + 2 * u)};
  for (Index k = 0; k < m; ++k) {
    r.lambda(k) = Complex(0, s.omega(k));
    r.right.col(k) = s.shape(k).normalized();
  }
  r.left.leftCols(m) = r.right.leftCols(m);
  for (Index k = 0; k < u; ++k) {
    const Complex lambda = s.unstable.lambda[static_cast<std::size_t>(k)];
    r.lambda(m + k) = lambda;
    r.lambda(m + u + k) = -std::conj(lambda);
    r.right.col(m + k) = r.left.col(m + u + k) = s.unstable.right.col(k).normalized();
    r.left.col(m + k) = r.right.col(m + u + k) = s.unstable.left.col(k).normalized();
  }
  const CharacteristicProducts p = h.characteristic_products(r.right.leftCols(m + u));
  for (Index k = 0; k < m + u; ++k) r.slope(k) = r.left.col(k).dot(p.g.col(k) + 2.0 * r.lambda(k) * p.m.col(k));
  for (Index k = 0; k < u; ++k) r.slope(m + u + k) = -std::conj(r.slope(m + k));
  return r;
}

// The shares −y_kᴴr_i/((λ_i − λ_k)s_k), in place of y_kᴴr_i; those that are not small, of roots that coincide with λ_i
// to rounding, are none.
void divide(ComplexMatrix& shares, const ComplexVector& lambda, const ComplexVector& slope, const ComplexVector& of,
            const std::vector<Index>& self) {
  constexpr double small = 0.05;
  for (Index i = 0; i < shares.cols(); ++i) {
    for (Index k = 0; k < shares.rows(); ++k) {
      const Complex share = -shares(k, i) / ((of(i) - lambda(k)) * slope(k));
      shares(k, i) = std::abs(share) <= small && !(static_cast<std::size_t>(i) < self.size() && self[static_cast<std::size_t>(i)] == k)
                         ? share
                         : Complex(0, 0);
    }
  }
}

// Corrected columns x of roots `of`; `self` their positions among the roots.
ComplexMatrix corrected(const Impedance& h, const Roots& all, const ComplexVector& of, const ComplexMatrix& x,
                        const std::vector<Index>& self) {
  const CharacteristicProducts p = h.characteristic_products(x);
  const ComplexMatrix r = p.k + p.g * of.asDiagonal() + p.m * ComplexVector(of.array().square()).asDiagonal();
  ComplexMatrix shares = lapack::multiply_adjoint(all.left, r);
  divide(shares, all.lambda, all.slope, of, self);
  ComplexMatrix y = x + lapack::multiply_complex(all.right, shares);
  // The conjugate roots; a real one is its own conjugate, and counted already.
  const ComplexMatrix left = all.left.conjugate(), right = all.right.conjugate();
  shares = lapack::multiply_adjoint(left, r);
  divide(shares, all.lambda.conjugate(), all.slope.conjugate(), of, {});
  for (Index k = 0; k < all.lambda.size(); ++k) {
    if (all.lambda(k).imag() == 0) shares.row(k).setZero();
  }
  return y + lapack::multiply_complex(right, shares);
}

}  // namespace

void correct_shapes(const Impedance& h, Spectrum& s, const std::vector<Index>& modes, const std::vector<Index>& unstable) {
  const Roots all = all_roots(h, s);
  const Index m = s.omega.size(), u = s.unstable.count();
  if (!modes.empty()) {
    const ComplexMatrix x = corrected(h, all, all.lambda(modes), all.right(Eigen::all, modes), modes);
    for (std::size_t k = 0; k < modes.size(); ++k) {
      s.re.col(modes[k]) = x.col(static_cast<Index>(k)).head(s.re.rows()).real();
      s.im.col(modes[k]) = x.col(static_cast<Index>(k)).tail(s.im.rows()).imag();
    }
  }
  if (unstable.empty()) return;
  std::vector<Index> growing, decaying;
  for (const Index k : unstable) {
    growing.push_back(m + k);
    decaying.push_back(m + u + k);
  }
  const ComplexMatrix right = corrected(h, all, all.lambda(growing), all.right(Eigen::all, growing), growing);
  const ComplexMatrix left = corrected(h, all, all.lambda(decaying), all.right(Eigen::all, decaying), decaying);
  s.unstable.right(Eigen::all, unstable) = right;
  s.unstable.left(Eigen::all, unstable) = left;
}

}  // namespace gyromode::dense
