#pragma once

#include "gyromode/appendage/hub_matrix.h"

#include <vector>

namespace gyromode {

/// A point mass held to the body by three springs along the body axes. An infinite stiffness is a rigid connection in that direction.
struct SpringMass {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m, from O, where it sits while the satellite spins steadily
  double mass = 0;                                     ///< kg, > 0
  Eigen::Vector3d stiffness = Eigen::Vector3d::Zero(); ///< N/m, ≥ 0 or infinite
};

/// What the mass does to the body at a given spin (rad/s): its displacement u in body axes is condensed out of
///     −m N on d = ζ + θ × p + u,  N = [p jt 0; −jt p 0; 0 0 ω²],   diag(k) on u,
/// and the static terms of its centrifugal force mΩ²Pp, P = diag(1, 1, 0):
///     −mΩ²(½((Pp)pᵀ + p(Pp)ᵀ) − (Pp·p)1) on θθ,   mΩ²[Pp]× on θu.
class SpringMassImpedance {
 public:
  SpringMassImpedance(const SpringMass& mass, double spin) : mass_(mass), spin_(spin) {}

  /// Hermitian. Infinite entries at a fixed-root frequency.
  HubMatrix at(double omega) const;
  /// n₋ of the impedance of the mass with the body held.
  Index fixed_root_negative(double omega) const;

 private:
  using Matrix3c = Eigen::Matrix3cd;
  Matrix3c inertia(double omega) const;           // −m N
  Eigen::MatrixXcd held(double omega) const;      // on the directions with a spring
  std::vector<int> sprung() const;

  SpringMass mass_;
  double spin_;
};

}  // namespace gyromode
