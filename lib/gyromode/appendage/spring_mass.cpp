#include "gyromode/appendage/spring_mass.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>

namespace gyromode {

namespace {

Eigen::Matrix3d cross(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0, -a(2), a(1), a(2), 0, -a(0), -a(1), a(0), 0;
  return m;
}

}  // namespace

std::vector<int> SpringMassImpedance::sprung() const {
  std::vector<int> directions;
  for (int i = 0; i < 3; ++i) {
    if (std::isfinite(mass_.stiffness(i))) directions.push_back(i);
  }
  return directions;
}

Eigen::Matrix3cd SpringMassImpedance::inertia(double omega) const {
  const Complex jt(0, 2 * omega * spin_);
  const double p = omega * omega + spin_ * spin_;
  Matrix3c n = Matrix3c::Zero();
  n(0, 0) = n(1, 1) = p;
  n(0, 1) = jt;
  n(1, 0) = -jt;
  n(2, 2) = omega * omega;
  return -mass_.mass * n;
}

Eigen::MatrixXcd SpringMassImpedance::held(double omega) const {
  const auto free = sprung();
  Matrix3c h = inertia(omega);
  for (const int i : free) h(i, i) += mass_.stiffness(i);
  return h(free, free);
}

HubMatrix SpringMassImpedance::at(double omega) const {
  const Eigen::Vector3d& p = mass_.position;
  const Eigen::Vector3d in_plane(p(0), p(1), 0);
  const double force = mass_.mass * spin_ * spin_;
  Eigen::Matrix<double, 3, 6> d;  // displacement of the place p by the body
  d << Eigen::Matrix3d::Identity(), -cross(p);
  const Matrix3c z = inertia(omega);
  HubMatrix hub = d.transpose() * z * d;
  hub.bottomRightCorner<3, 3>() -=
      force * (0.5 * (in_plane * p.transpose() + p * in_plane.transpose()) - in_plane.dot(p) * Eigen::Matrix3d::Identity()).cast<Complex>();
  const auto free = sprung();
  if (free.empty()) return hub;
  Eigen::Matrix<Complex, 6, 3> coupling = d.transpose() * z;
  coupling.bottomRows<3>() += force * cross(in_plane).cast<Complex>();
  const Eigen::MatrixXcd c = coupling(Eigen::all, free);
  const HubMatrix condensed = c * held(omega).inverse() * c.adjoint();
  hub -= 0.5 * (condensed + condensed.adjoint());
  return hub;
}

Index SpringMassImpedance::fixed_root_negative(double omega) const {
  const Eigen::MatrixXcd h = held(omega);
  if (h.size() == 0) return 0;
  return (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>(h, Eigen::EigenvaluesOnly).eigenvalues().array() < 0).count();
}

}  // namespace gyromode
