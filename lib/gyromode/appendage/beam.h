#pragma once

#include "gyromode/appendage/hub_matrix.h"

namespace gyromode {

/// A Euler–Bernoulli boom along axis 3, clamped at its root, with a point mass at its tip. It carries no axial load, and its inertia about its own axis is left out.
struct Beam {
  double root_height = 0;        ///< m, above O
  bool upward = true;            ///< direction of axis 3, or against it
  double length = 0;             ///< m, > 0
  double line_density = 0;       ///< kg/m, > 0
  double bending_stiffness[2] = {0, 0};  ///< N m², for motion along axes 1 and 2, > 0
  double tip_mass = 0;           ///< kg, ≥ 0

  double mass() const { return line_density * length + tip_mass; }
};

/// What a boom does to the body at a given spin (rad/s), exactly, at any frequency.
class BeamImpedance {
 public:
  BeamImpedance(const Beam& beam, double spin) : beam_(beam), spin_(spin) {}

  /// H_beam(ω), Hermitian. With η = jY the transverse motion is real and falls apart into two cantilevers: ρN φ = κ E φ, N = [[p, t], [t, p]], p = ω² + Ω²,
  /// t = 2ωΩ, E the bending stiffnesses.
  HubMatrix at(double omega) const;
  /// n₋ of the impedance of the boom with its root held, of both cantilevers at their κ(ω): where its first frequency is above the spin, how many of its frequencies in
  /// turning axes are below ω > 0. A softer boom begins with what its spin makes negative.
  Index fixed_root_negative(double omega) const;

 private:
  struct Pair {
    double kappa[2];
    Eigen::Matrix2d v;  // columns Eφ_k, φ_kᵀEφ_k = 1
  };
  Pair decoupled(double omega) const;

  Beam beam_;
  double spin_;
};

}  // namespace gyromode
