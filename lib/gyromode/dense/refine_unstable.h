#pragma once

#include "gyromode/dense/impedance.h"

namespace gyromode::dense {

/// A root λ off the imaginary axis of N(λ) X = 0, N(λ) = K + λG + λ²M.
struct UnstableRoot {
  Complex lambda;
  ComplexVector shape;     ///< X, unit length, in the order of the Spectrum
  double sensitivity = 0;  ///< |δλ| for a backward error of 1 relative to ‖K‖ + |λ|‖G‖ + |λ|²‖M‖, to first order
};

/// Two-sided Rayleigh quotient iteration, λ − YᴴN(λ)X / YᴴN′(λ)X with X and Y from inverse iteration on both sides, started at `lambda`. A real
/// λ stays real. Where the iteration goes farther than `reach`, or does not settle, the start is returned with the sensitivity found there.
UnstableRoot refine_unstable(const Impedance& h, Complex lambda, double reach);

}  // namespace gyromode::dense
