#pragma once

#include "gyromode/motion/energy_norm.h"
#include "gyromode/motion/modal_part.h"
#include "gyromode/motion/zero_part.h"

namespace gyromode {

/// What is left of a motion when its simple undamped modes and its zero roots are taken out: growth and decay, and
/// double roots of opposite energies. Those span an invariant subspace of known dimension, the range of the projection
/// that strips everything else. An orthonormal basis of the whole of it is made from random states, stripped: it
/// belongs to the system, and no motion has a part in its making, so that a remainder that is only rounding cannot turn
/// it. Time goes by through the exponential of the small matrix, or, at a double root jω, exactly as e^{jωt}(1 + tN)
/// with N² = 0: linear in t.
class Remainder {
 public:
  /// `dimension`: of the subspace, 2n less what the two parts have. `norm` must outlive it.
  Remainder(const ComponentMatrices& m, const EnergyNorm& norm, const ModalPart& modal, const ZeroPart& zero, Index dimension);

  Index size() const { return basis_.cols(); }
  Vector coordinates(const State& w) const;
  State state(const Vector& y) const;
  Vector moved(const Vector& y, double t) const;
  /// The response to g cos νt from rest.
  Vector driven(const Vector& g, double nu, double t) const;

  /// How far from invariant the basis is: the size, beside its own length 1, of the correction that would take the
  /// parts of A·basis − basis·generator in the modes away, A the matrix of the motion; what is in no mode, relative to
  /// the generator.
  double departure() const { return departure_; }
  /// What rounding may have made of the rates of the generator, in 1 over the unit of time.
  double rate_error() const { return rate_error_; }

 private:
  struct Correction {
    Matrix basis;
    double size;
  };
  Matrix image(const ComponentMatrices& m) const;  // A·basis
  Correction correction(const ComponentMatrices& m, const ModalPart& modal, Matrix departure) const;
  void take_rounding(const ComponentMatrices& m);
  Matrix exponential(double t) const;
  void recognise_double_root();

  const EnergyNorm* norm_;  // of which x are coordinates
  Matrix basis_;            // 2n × d, orthonormal, of x
  Matrix generator_;        // d × d: ẏ = generator y, per unit of time
  double departure_ = 0, rate_error_ = 0;
  double double_root_ = 0;  // ω of a double pair ±jω, 0 where the generator is none
  Matrix semisimple_, nilpotent_;
};

/// w less its parts in the modes and in the zero roots, twice over.
State stripped(const ComponentMatrices& m, const ModalPart& modal, const ZeroPart& zero, State w);

}  // namespace gyromode
