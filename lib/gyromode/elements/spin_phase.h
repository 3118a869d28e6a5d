#pragma once

#include "gyromode/system/system.h"

namespace gyromode {

/// A system without its cyclic coordinate, one that no stored energy contains (row of K zero): angular momentum about
/// the spin axis is constant, m₃₃θ̇₃ + m₃ᵀq̇ + g₃ᵀq = 0, and (Routh)
///     M − m₃m₃ᵀ/m₃₃,   G − (m₃g₃ᵀ − g₃m₃ᵀ)/m₃₃,   K + g₃g₃ᵀ/m₃₃
/// on the others. Its root is the pair of zero roots of the spin phase, which is left out of verdicts.
class WithoutSpinPhase {
 public:
  WithoutSpinPhase(const System& whole, Index cyclic);

  const System& system() const { return system_; }
  /// The shape of a mode of the rest with the cyclic coordinate back in its place; ω > 0.
  ComplexVector restored(const ComplexVector& shape, double omega) const;

 private:
  Index cyclic_;
  double m33_;
  Vector m3_, g3_;
  System system_;
};

/// The system in the span of the modes it would have at rest (G left out) with |ω²| up to `limit`²: small, and without
/// the stiffness of fine meshes. An approximation.
System low_modes(const System& system, double limit);

}  // namespace gyromode
