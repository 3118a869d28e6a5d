#pragma once

#include "gyromode/motion/modal_part.h"
#include "gyromode/motion/zero_part.h"

#include <vector>

namespace gyromode {

/// What is left of a motion when its simple undamped modes and its zero roots are taken out: growth and decay, and double roots of opposite energies. An orthonormal basis of the
/// invariant subspace is grown from the motions that matter by Arnoldi steps, everything else projected out at each; time goes by through the exponential of the small matrix, or, at a double root
/// jω, exactly as e^{jωt}(1 + tN) with N² = 0: linear in t.
class Remainder {
 public:
  /// `dimension`: of the subspace, 2n less what the two parts have; `starts`: states within it up to rounding, to be followed.
  Remainder(const ComponentMatrices& m, const ModalPart& modal, const ZeroPart& zero, Index dimension, double unit_frequency, const std::vector<State>& starts);

  Index size() const { return basis_.cols(); }
  Vector coordinates(const State& w) const;
  State state(const Vector& y) const;
  Vector moved(const Vector& y, double t) const;
  /// The response to g cos νt from rest.
  Vector driven(const Vector& g, double nu, double t) const;

 private:
  Vector scaled(const State& w) const;
  Matrix exponential(double t) const;
  void recognise_double_root();

  Vector scale_;      // q = scale · q̂, q̇ = scale · unit · v̂
  double unit_ = 1;
  Matrix basis_;      // 2n × d, orthonormal, of (q̂, v̂)
  Matrix generator_;  // d × d: ẏ = generator y, per unit of time
  double double_root_ = 0;  // ω of a double pair ±jω, 0 where the generator is none
  Matrix semisimple_, nilpotent_;
};

/// w less its parts in the modes and in the zero roots, twice over.
State stripped(const ComponentMatrices& m, const ModalPart& modal, const ZeroPart& zero, State w);

}  // namespace gyromode
