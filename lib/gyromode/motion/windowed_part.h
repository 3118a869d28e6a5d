#pragma once

#include "gyromode/motion/state.h"
#include "gyromode/sparse/sparse_system.h"
#include "gyromode/spectrum/result.h"

namespace gyromode {

/// Displacements and velocities of a motion Re(… e^{jνt}).
struct ComplexState {
  ComplexVector q;     ///< n
  ComplexVector qdot;  ///< n
};

/// Modes of a window as a part of what a sparse system can do, (q, q̇) = Σ 2 Re a_s (X_s, jω_s X_s) e^{jω_s t}, with
/// the amplitudes of ModalPart. Coordinates are those that the system is written in.
class WindowedPart {
 public:
  /// Those with a frequency and a sign of energy, of which `found` has the shapes.
  WindowedPart(const SparseSystem& system, const ModesResult& found);

  Index size() const { return omega_.size(); }
  const Vector& omega() const { return omega_; }
  const Vector& form() const { return form_; }                ///< Xᴴ(2ωM − jG)X
  const Vector& error() const { return error_; }              ///< bounds on |δω|
  const std::vector<Index>& which() const { return which_; }  ///< of the modes found

  ComplexVector amplitudes(const State& w) const;
  /// ȧ = jωa + h u(t) of a force f u(t).
  ComplexVector pushed(const Vector& force) const;
  State state(const ComplexVector& a) const;
  /// What the force f e^{jνt} pushes beside these modes, as the right side of H(ν)q = r.
  ComplexVector beyond(const Vector& force, double nu) const;
  /// Takes these modes and their mirror images out of (q, jνq − v) with v what a force pushes them by.
  ComplexVector without_modes(const ComplexVector& q, const Vector& force, double nu) const;

 private:
  ComplexVector amplitudes(const ComplexState& w, bool mirrored) const;

  const SparseSystem& system_;
  std::vector<Index> which_;
  Vector omega_, form_, error_;
  ComplexMatrix shapes_, mass_times_, gyroscopic_times_;  // X, MX, GX
};

}  // namespace gyromode
