#pragma once

#include "gyromode/system/system.h"

namespace gyromode {

/// A system for every spin Ω of its axes or of its rotor, as data:
///     M q̈ + (G₀ + ΩG₁) q̇ + (K₀ + Ω²K₂) q = 0.
/// All matrices n × n; G₁ or K₂ is empty where nothing depends on the spin.
struct SpinFamily {
  Matrix mass;                 ///< M
  Matrix gyroscopic;           ///< G₀
  Matrix gyroscopic_per_spin;  ///< G₁, or empty
  Matrix stiffness;            ///< K₀
  Matrix stiffness_per_spin2;  ///< K₂, or empty
  Labels labels;               ///< of the coordinates; empty: q1 … qn
  Admission admission = {};    ///< how far M, G and K at any spin may be from (skew-)symmetric

  /// G and K at one spin.
  struct Sum {
    Matrix gyroscopic;  ///< G₀ + ΩG₁
    Matrix stiffness;   ///< K₀ + Ω²K₂
  };
  /// G and K at one spin, rad per unit of time. @throws LawBroken where orders differ
  Sum sum(double spin) const;
  /// The system at one spin, rad per unit of time. Throws LawBroken.
  System at(double spin) const;
};

}  // namespace gyromode
