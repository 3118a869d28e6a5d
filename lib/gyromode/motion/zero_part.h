#pragma once

#include "gyromode/motion/modal_part.h"

namespace gyromode {

/// The motion of the zero roots of a component: rest in a displaced place, N y with KN = 0, and steady drift, (r + vt)
/// y with Kr = −Gv, Kv = 0. Exactly linear in t. The projection is the one of 𝒮 (ModalPart), regular on this space.
class ZeroPart {
 public:
  /// `pairs`: of zero roots, as the solver found. Where longer chains than drift are needed for so many, none is made:
  /// complete() is false and the Remainder has them.
  ZeroPart(const ComponentMatrices& matrices, Index pairs);

  Index size() const { return places_.cols() + drifts_.cols(); }
  bool complete() const { return complete_; }
  /// Coordinates (places, drifts) of the part of w in this space.
  Vector coordinates(const ComponentMatrices& m, const State& w) const;
  /// g of ẏ = Ny + g u(t) for a force f u(t).
  Vector excitation(const Vector& force) const;
  /// Σ of the moduli that excitation() adds up: what its rounding is relative to.
  Vector largest_excitation(const Vector& force) const;
  State state(const Vector& y) const;
  /// y at time t of free motion, and the response to g cos νt from rest.
  Vector moved(const Vector& y, double t) const;
  Vector driven(const Vector& g, double nu, double t) const;

 private:
  bool complete_ = true;
  Matrix places_;           // n × r: N
  Matrix drifts_;           // n × k: r, beside the velocities
  Matrix velocities_;       // n × k: v = N · combination_
  Matrix combination_;      // r × k
  Matrix dual_q_, dual_v_;  // size × n: coordinates = dual_q (Gq + Mq̇) − dual_v Mq
};

}  // namespace gyromode
