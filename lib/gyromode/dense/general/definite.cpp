#include "gyromode/dense/general/definite.h"

#include "gyromode/dense/general/skew_tridiagonal.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/reflectors.h"
#include "gyromode/lapack/singular.h"

namespace gyromode::dense {

namespace {

// D b = ω a for the bidiagonal D of T: rows 0, 2, … and columns 1, 3, … of T, T = [0 D; −Dᵀ 0] after that permutation.
// An odd order is padded with a row of zeros. Dᵀ is upper bidiagonal: Dᵀ = U ω Vᵀ, so b is U and a is V, the largest ω
// first.
lapack::SingularValues halved(const Vector& beta, Index order) {
  const Index m = (order + 1) / 2;
  Vector diagonal = Vector::Zero(m);
  Vector superdiagonal = Vector::Zero(std::max<Index>(m - 1, 0));
  for (Index i = 0; i < m; ++i) {
    if (2 * i < beta.size()) diagonal(i) = -beta(2 * i);  // D(i, i) = T(2i, 2i + 1)
    if (i + 1 < m) superdiagonal(i) = beta(2 * i + 1);    // D(i + 1, i) = T(2i + 2, 2i + 1)
  }
  return lapack::bidiagonal_svd(std::move(diagonal), std::move(superdiagonal));
}

// Every second column of x, `count` of them from `start` on, without a copy.
auto every_second(const Matrix& x, Index start, Index count) {
  return Eigen::Map<const Matrix, 0, Eigen::OuterStride<>>(x.data() + start * x.rows(), x.rows(), count,
                                                           Eigen::OuterStride<>(2 * x.rows()));
}

}  // namespace

ComplexModes definite_modes(const Matrix& gamma, const Matrix& f) {
  const Index n = gamma.rows();
  const Index q = f.cols();
  Matrix z = Matrix::Zero(n + q, n + q);
  z.bottomLeftCorner(n, q) = -f;
  z.bottomRightCorner(n, n) = -gamma;
  const SkewTridiagonal t(std::move(z));
  const auto svd = halved(t.subdiagonal(), n + q);
  // The velocity rows of Q: L_Mᵀq̇ = (Qy)₂ with y = (a, jb), so X = (Qy)₂/(jω).
  Matrix q2 = Matrix::Zero(n, n + q);
  q2.rightCols(n).setIdentity();
  lapack::multiply_right(q2, t.q());
  const Index m = svd.values.size();
  ComplexModes modes{svd.values.reverse(), lapack::multiply(every_second(q2, 1, m), svd.u),
                     lapack::multiply_nt(every_second(q2, 0, m), svd.vt)};
  const Vector inverse = svd.values.cwiseInverse();
  modes.re *= inverse.asDiagonal();
  modes.im *= (-inverse).asDiagonal();
  modes.re.rowwise().reverseInPlace();
  modes.im.rowwise().reverseInPlace();
  return modes;
}

ComplexModes skew_modes(const Matrix& g, double threshold) {
  const Index n = g.rows();
  const SkewTridiagonal t(g);
  const auto svd = halved(t.subdiagonal(), n);
  Matrix q = Matrix::Identity(n, n);
  lapack::multiply_right(q, t.q());
  const Index m = (svd.values.array() > threshold).count();
  // gX = −jωX: X = Q (a, −jb).
  ComplexModes modes{svd.values.head(m).reverse(), lapack::multiply_nt(every_second(q, 0, (n + 1) / 2), svd.vt.topRows(m)),
                     -lapack::multiply(every_second(q, 1, n / 2), svd.u.topLeftCorner(n / 2, m))};
  modes.re.rowwise().reverseInPlace();
  modes.im.rowwise().reverseInPlace();
  return modes;
}

}  // namespace gyromode::dense
