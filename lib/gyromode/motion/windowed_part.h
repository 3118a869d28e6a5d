#pragma once

#include "gyromode/motion/state.h"
#include "gyromode/sparse/sparse_system.h"
#include "gyromode/spectrum/result.h"

namespace gyromode {

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

  /// What of a state is in these modes.
  struct Share {
    ComplexVector amplitudes;  ///< a
    double size = 0;           ///< √(Σ ω|form||a|²), of energies
    double missing = 0;        ///< the same of what is still in the modes after it was taken out, as often as it gets less
  };
  /// Of (q, q̇) with the momentum p = Mq̇. A force f u(t) pushes (0, p = f): ȧ = jωa + h u(t).
  Share share_of(const Vector& q, const Vector& momentum) const;
  State state(const ComplexVector& a) const;
  /// What a force f e^{jνt} that pushes the modes by h pushes beside them, as the right side of H(ν)q = r.
  ComplexVector beyond(const Vector& force, const ComplexVector& h, double nu) const;
  /// q of that motion, (q, jνq − q̃), without what is left of these modes and of their mirror images.
  ComplexVector without_modes(const ComplexVector& q, const ComplexVector& h, double nu) const;

 private:
  /// Of (q, p) in the modes, or in their mirror images X̄ e^{−jωt}.
  ComplexVector amplitudes(const ComplexVector& q, const ComplexVector& momentum, bool mirrored) const;
  double size_of(const ComplexVector& a) const;
  /// Mq̇ of Σ 2 Re a (X, jωX).
  Vector momentum(const ComplexVector& a) const;

  const SparseSystem& system_;
  std::vector<Index> which_;
  Vector omega_, form_, error_;
  ComplexMatrix shapes_, mass_times_, gyroscopic_times_;  // X, MX, GX
};

}  // namespace gyromode
