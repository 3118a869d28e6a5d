#include "gyromode/motion/zero_part.h"

#include "gyromode/dense/basis.h"
#include "gyromode/lapack/singular.h"
#include "gyromode/lapack/small.h"
#include "gyromode/motion/time_course.h"
#include "gyromode/structure/inertia_of_k.h"
#include "gyromode/system/scale.h"

namespace gyromode {

namespace {

constexpr double regular = 1e-9;  // of an equilibrated Gram matrix: smaller is singular

// Vectors c with NᵀGNc = 0.
Matrix uncoupled(const Matrix& coupling, double scale) {
  const Index r = coupling.rows();
  if (r == 0) return Matrix(0, 0);
  const auto svd = lapack::singular_value_decomposition(coupling);
  const Index rank = (svd.values.array() > 1e-10 * scale).count();
  return svd.vt.bottomRows(r - rank).transpose();
}

// r with Kr = −Gv and NᵀDr = 0: [K B; Bᵀ 0] is regular for B = D⁻¹N, D the scale that takes the units out of K; NᵀGv =
// 0 makes the multipliers vanish.
Matrix displaced_by_drift(const ComponentMatrices& m, const Matrix& null, const Matrix& velocities) {
  const Index n = m.mass.rows(), r = null.cols();
  if (velocities.cols() == 0) return Matrix(n, 0);
  const Vector d = equilibrating_scale(m.stiffness);
  const Matrix basis = dense::orthonormal_basis(Matrix(d.cwiseInverse().asDiagonal() * null));
  Matrix bordered = Matrix::Zero(n + r, n + r);
  bordered.topLeftCorner(n, n) = scaled(m.stiffness, d);
  bordered.topRightCorner(n, r) = basis;
  bordered.bottomLeftCorner(r, n) = basis.transpose();
  Matrix right = Matrix::Zero(n + r, velocities.cols());
  right.topRows(n) = d.asDiagonal() * (-m.gyroscopic * velocities);
  return d.asDiagonal() * Matrix(small::solve(bordered, right).topRows(n));
}

}  // namespace

ZeroPart::ZeroPart(const ComponentMatrices& m, Index pairs) {
  const Index n = m.mass.rows();
  places_ = Matrix(n, 0);
  drifts_ = velocities_ = Matrix(n, 0);
  dual_q_ = dual_v_ = Matrix(0, n);
  if (pairs == 0) return;
  const Matrix null = inertia_of_k(m.stiffness).null_space;
  const Matrix coupling = null.transpose() * m.gyroscopic * null;
  const Matrix combination = uncoupled(coupling, m.gyroscopic.norm());
  const Matrix velocities = null * combination;
  const Matrix drifts = displaced_by_drift(m, null, velocities);
  const Index r = null.cols(), k = velocities.cols();
  if (r + k != 2 * pairs) {
    complete_ = false;
    return;
  }
  // Gram matrix Bᵀ𝒮B of B = (N, 0), (r, v):  wᵀ𝒮w′ = qᵀ(Gq′ + Mq̇′) − q̇ᵀMq′.
  Matrix b_q(n, r + k), b_v = Matrix::Zero(n, r + k);
  b_q << null, drifts;
  b_v.rightCols(k) = velocities;
  const Matrix gram = b_q.transpose() * (m.gyroscopic * b_q + m.mass * b_v) - b_v.transpose() * m.mass * b_q;
  const Vector scale = gram.cwiseAbs().rowwise().maxCoeff().cwiseSqrt().cwiseInverse();
  const Matrix equilibrated = scale.asDiagonal() * gram * scale.asDiagonal();
  if (!scale.allFinite() || !(small::reciprocal_condition(equilibrated) > regular)) {
    complete_ = false;
    return;
  }
  places_ = null;
  drifts_ = drifts;
  velocities_ = velocities;
  combination_ = combination;
  dual_q_ = scale.asDiagonal() * small::solve_fully_pivoted(equilibrated, scale.asDiagonal() * b_q.transpose());
  dual_v_ = scale.asDiagonal() * small::solve_fully_pivoted(equilibrated, scale.asDiagonal() * b_v.transpose());
}

Vector ZeroPart::coordinates(const ComponentMatrices& m, const State& w) const {
  return dual_q_ * (m.gyroscopic * w.q + m.mass * w.qdot) - dual_v_ * (m.mass * w.q);
}

Vector ZeroPart::excitation(const Vector& force) const { return dual_q_ * force; }

Vector ZeroPart::largest_excitation(const Vector& force) const { return dual_q_.cwiseAbs() * force.cwiseAbs(); }

State ZeroPart::state(const Vector& y) const {
  const Index r = places_.cols(), k = drifts_.cols();
  return {places_ * y.head(r) + drifts_ * y.tail(k), velocities_ * y.tail(k)};
}

Vector ZeroPart::moved(const Vector& y, double t) const {
  Vector at = y;
  if (drifts_.cols() > 0) at.head(places_.cols()) += t * (combination_ * y.tail(drifts_.cols()));
  return at;
}

Vector ZeroPart::driven(const Vector& g, double nu, double t) const {
  Vector at = once_integrated(nu, t) * g;
  if (drifts_.cols() > 0) at.head(places_.cols()) += twice_integrated(nu, t) * (combination_ * g.tail(drifts_.cols()));
  return at;
}

}  // namespace gyromode
