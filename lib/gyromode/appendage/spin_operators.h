#pragma once

#include "gyromode/base/types.h"

namespace gyromode {

/// (ξ1, ξ2, ξ3, θ1, θ2, φ3): θ1, θ2 the small rotations of the body; jξ the inertial velocity of the reference point in
/// turning axes, ξ = Bζ with B = [ω, jΩ; −jΩ, ω], ξ3 = ωζ3; jφ3 = jωθ3 the rate about the spin axis. B² = N = [p, jt;
/// −jt, p], the operator of inertia forces: translation and spin phase, which no force holds, have the constant entries
/// −m and −J33 in these coordinates, and nothing is lost at ω = Ω or ω → 0.
inline constexpr Index body_coordinates = 6;

/// The numbers that B and N are made of. The formal j is +j for H itself and −j for the left side of a border, so that
/// everything is analytic in a complex ω.
template <class T>
struct SpinOperators {
  T omega, p, t;  // p = ω² + Ω², t = 2ωΩ
  double spin;
  Complex j;

  SpinOperators(const T& w, double spin_, Complex j_) : omega(w), p(w * w + spin_ * spin_), t(2.0 * w * spin_), spin(spin_), j(j_) {}
};

/// N₃ = [p jt 0; −jt p 0; 0 0 ω²]: inertia forces of a mass m are −mN₃ on its displacement.
template <class T>
Eigen::Matrix3cd inertia_operator(const SpinOperators<T>& f) {
  Eigen::Matrix3cd n = Eigen::Matrix3cd::Zero();
  n(0, 0) = n(1, 1) = f.p;
  n(0, 1) = f.j * f.t;
  n(1, 0) = -f.j * f.t;
  n(2, 2) = f.omega * f.omega;
  return n;
}

}  // namespace gyromode
