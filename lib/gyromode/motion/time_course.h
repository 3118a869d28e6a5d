#pragma once

#include "gyromode/base/types.h"

namespace gyromode {

/// sin(x)/x.
double sinc(double x);

/// ∫₀ᵗ e^{jω(t − s)} cos(νs) ds, without loss at resonance, ω = ν, where it grows as t: what a force cos νt leaves in a
/// mode of frequency ω.
Complex forced(double omega, double nu, double t);
/// ∫₀ᵗ τ e^{jωτ} cos(ν(t − τ)) dτ, the same for a motion t e^{jωt}, as a double root has.
Complex forced_twice(double omega, double nu, double t);
/// ∫₀ᵗ cos(νs) ds and its integral over t.
double once_integrated(double nu, double t);
double twice_integrated(double nu, double t);

}  // namespace gyromode
