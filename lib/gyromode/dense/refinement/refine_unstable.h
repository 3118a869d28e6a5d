#pragma once

#include "gyromode/dense/impedance.h"

#include <optional>

namespace gyromode::dense {

/// A root λ off the imaginary axis of N(λ) X = 0, N(λ) = K + λG + λ²M, with Y for −λ̄: YᴴN(λ) = 0. Unit length each, in
/// the order of the Spectrum.
struct UnstableRoot {
  Complex lambda;
  ComplexVector right, left;
};

/// Two-sided Rayleigh quotient iteration, λ − YᴴN(λ)X / YᴴN′(λ)X with X and Y from inverse iteration on both sides (N
/// equilibrated), started at `lambda`. A real λ stays real. Nothing where the iteration goes farther than `reach`, or
/// does not settle.
std::optional<UnstableRoot> refine_unstable(const Impedance& h, Complex lambda, double reach);

}  // namespace gyromode::dense
