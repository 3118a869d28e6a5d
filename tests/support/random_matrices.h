#pragma once

#include "gyromode/base/types.h"
#include "gyromode/lapack/small.h"
#include "gyromode/lapack/triangular.h"

#include <random>

namespace gyromode::support {

inline Matrix gaussian(std::mt19937_64& bits, Index rows, Index cols) {
  std::normal_distribution<double> normal;
  Matrix a(rows, cols);
  for (double& x : a.reshaped()) x = normal(bits);
  return a;
}

/// Makes the first n/2 coordinates in phase with each other and in quadrature with the rest: M and K couple within the
/// groups, G across.
inline void make_quadrature(Matrix& m, Matrix& g, Matrix& k) {
  const Index p = m.rows() / 2, r = m.rows() - p;
  for (Matrix* a : {&m, &k}) {
    a->topRightCorner(p, r).setZero();
    a->bottomLeftCorner(r, p).setZero();
  }
  g.topLeftCorner(p, p).setZero();
  g.bottomRightCorner(r, r).setZero();
}

/// Seeded random matrices for tests of one solver.
struct Source {
  std::mt19937_64 bits;

  Index integer(Index a, Index b) { return std::uniform_int_distribution<Index>(a, b)(bits); }
  Matrix gaussian(Index rows, Index cols) { return support::gaussian(bits, rows, cols); }
  Matrix integers(Index rows, Index cols, Index most) {
    Matrix a(rows, cols);
    for (double& x : a.reshaped()) x = static_cast<double>(integer(-most, most));
    return a;
  }
  Matrix orthogonal(Index n) { return small::orthogonal_factor(gaussian(n, n)); }
  Matrix skew(Index n) {
    const Matrix a = gaussian(n, n);
    return a - a.transpose();
  }
  /// Symmetric with |eigenvalues| in [0.5, 2], `negative` of them below zero.
  Matrix symmetric(Index n, Index negative) {
    Vector d(n);
    for (Index i = 0; i < n; ++i) d(i) = std::uniform_real_distribution<double>(0.5, 2)(bits) * (i < negative ? -1 : 1);
    const Matrix q = orthogonal(n);
    const Matrix k = q * d.asDiagonal() * q.transpose();
    return 0.5 * (k + k.transpose());
  }
};

inline Matrix lower_root(const Matrix& k) { return lapack::Cholesky(k).lower(); }

}  // namespace gyromode::support
