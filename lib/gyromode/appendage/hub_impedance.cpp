#include "gyromode/appendage/hub_impedance.h"

#include "gyromode/lapack/small.h"

#include <numeric>

namespace gyromode {

namespace {

Eigen::Matrix3cd cross(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0, -a(2), a(1), a(2), 0, -a(0), -a(1), a(0), 0;
  return m.cast<Complex>();
}

// The excess of one appendage.
Lifted alone(const Appendage& appendage, double omega) {
  const Index size = body_coordinates + appendage.coordinates();
  Lifted l{ComplexMatrix::Zero(size, size), std::vector<Index>(static_cast<std::size_t>(size), 0)};
  appendage.add(omega, l, body_coordinates);
  return l;
}

}  // namespace

HubMatrix body_coordinates_of(double omega, double spin) {
  const Complex j(0, 1);
  HubMatrix t = HubMatrix::Identity();
  t(0, 0) = t(1, 1) = t(2, 2) = t(5, 5) = omega;
  t(0, 1) = j * spin;
  t(1, 0) = -j * spin;
  return t;
}

HubMatrix condensed(const Lifted& lifted) {
  const Index own = lifted.matrix.rows() - body_coordinates;
  HubMatrix h = lifted.matrix.topLeftCorner<body_coordinates, body_coordinates>();
  if (own == 0) return h;
  const ComplexMatrix border = lifted.matrix.bottomLeftCorner(own, body_coordinates);
  const ComplexMatrix kept = lifted.matrix.bottomRightCorner(own, own);
  h -= border.adjoint() * small::solve_fully_pivoted(kept, border);
  return 0.5 * (h + h.adjoint());
}

HubMatrix rigid_impedance(const MassProperties& m, double omega, double spin) {
  const Eigen::Matrix3cd n = inertia_operator(SpinOperators<double>(omega, spin, Complex(0, 1)));
  HubMatrix h = HubMatrix::Zero();
  h.topLeftCorner<3, 3>() = -m.mass * n;
  h.topRightCorner<3, 3>() = n * cross(m.first);
  h.bottomLeftCorner<3, 3>() = h.topRightCorner<3, 3>().adjoint();
  Eigen::Matrix3cd turned = Eigen::Matrix3cd::Zero();  // ∫ [p]× N [p]× dm
  for (Index a = 0; a < 3; ++a) {
    for (Index b = 0; b < 3; ++b) turned += m.second(a, b) * (cross(Eigen::Vector3d::Unit(a)) * n * cross(Eigen::Vector3d::Unit(b)));
  }
  Eigen::Matrix3d across = m.second;
  across.row(2).setZero();  // P ∫ p pᵀ dm
  const Eigen::Matrix3d steady = 0.5 * (across + across.transpose()) - across.trace() * Eigen::Matrix3d::Identity();
  h.bottomRightCorner<3, 3>() = turned - (spin * spin * steady).cast<Complex>();
  return h;
}

HubMatrix hub_impedance(const Appendage& appendage, double omega, double spin) {
  const Lifted l = alone(appendage, omega);
  const HubMatrix t = body_coordinates_of(omega, spin);
  const HubMatrix h = t.adjoint() * condensed(l) * t + rigid_impedance(appendage.rigid(), omega, spin);
  return 0.5 * (h + h.adjoint());
}

Index fixed_root_negative(const Appendage& appendage, double omega) {
  const Lifted l = alone(appendage, omega);
  const Index own = appendage.coordinates();
  Index count = std::accumulate(l.poles_below.begin(), l.poles_below.end(), Index{0});
  if (own > 0) {
    const ComplexMatrix kept = l.matrix.bottomRightCorner(own, own);
    count += (small::hermitian_eigenvalues(kept).array() < 0).count();
  }
  return count;
}

}  // namespace gyromode
