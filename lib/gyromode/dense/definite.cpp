#include "gyromode/dense/definite.h"

#include "gyromode/dense/skew_tridiagonal.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/singular.h"

namespace gyromode::dense {

namespace {

// D b = ω a for the bidiagonal D of T: rows 0, 2, … and columns 1, 3, … of T, T = [0 D; −Dᵀ 0] after that permutation. An odd order is
// padded with a row of zeros.
struct Halves {
  Vector omega;  // ascending
  Matrix a, b;   // columns belong to omega
};

Halves halve(const Vector& beta, Index order) {
  const Index m = (order + 1) / 2;
  Vector diagonal = Vector::Zero(m);
  Vector superdiagonal = Vector::Zero(std::max<Index>(m - 1, 0));
  for (Index i = 0; i < m; ++i) {
    if (2 * i < beta.size()) diagonal(i) = -beta(2 * i);                        // D(i, i) = T(2i, 2i + 1)
    if (i + 1 < m) superdiagonal(i) = beta(2 * i + 1);                          // D(i + 1, i) = T(2i + 2, 2i + 1)
  }
  const auto svd = lapack::bidiagonal_svd(diagonal, superdiagonal);             // of Dᵀ, which is upper bidiagonal
  return {svd.values.reverse(), svd.v.rowwise().reverse(), svd.u.rowwise().reverse()};
}

// Every second column of x, from `start`.
Matrix every_second(const Matrix& x, Index start, Index count) {
  Matrix y(x.rows(), count);
  for (Index i = 0; i < count; ++i) y.col(i) = x.col(start + 2 * i);
  return y;
}

}  // namespace

ComplexModes definite_modes(const Matrix& gamma, const Matrix& f) {
  const Index n = gamma.rows();
  const Index q = f.cols();
  Matrix z = Matrix::Zero(n + q, n + q);
  z.bottomLeftCorner(n, q) = -f;
  z.bottomRightCorner(n, n) = -gamma;
  const SkewTridiagonal t(std::move(z));
  const Halves h = halve(t.subdiagonal(), n + q);
  // The velocity rows of Q: L_Mᵀq̇ = (Qy)₂ with y = (a, jb), so X = (Qy)₂/(jω).
  Matrix q2 = Matrix::Zero(n, n + q);
  q2.rightCols(n).setIdentity();
  t.multiply_right(q2);
  const Index m = h.omega.size();
  const auto inverse = h.omega.cwiseInverse().asDiagonal();
  ComplexModes modes{h.omega, lapack::multiply(every_second(q2, 1, m), h.b), lapack::multiply(every_second(q2, 0, m), h.a)};
  modes.re = modes.re * inverse;
  modes.im = -modes.im * inverse;
  return modes;
}

ComplexModes skew_modes(const Matrix& g, double threshold) {
  const Index n = g.rows();
  const SkewTridiagonal t(g);
  const Halves h = halve(t.subdiagonal(), n);
  Matrix q = Matrix::Identity(n, n);
  t.multiply_right(q);
  const Index m = (h.omega.array() > threshold).count();
  // gX = −jωX: X = Q (a, −jb).
  ComplexModes modes{h.omega.tail(m), lapack::multiply(every_second(q, 0, (n + 1) / 2), h.a.rightCols(m)),
                     -lapack::multiply(every_second(q, 1, n / 2), h.b.topRightCorner(n / 2, m))};
  return modes;
}

}  // namespace gyromode::dense
