#pragma once

#include "gyromode/modes/matrix_spectrum.h"
#include "gyromode/system/condensation.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

namespace gyromode {

/// What the dropped part of each repaired matrix does to the modes and growing motions that `result` lists
/// (Repair::largest_effect), from all modes of `spectrum`. With λ²δM + λδG + δK = Δ(λ), roots λ_k of right and left
/// vectors x_k, y_k and slopes d_k = y_kᴴ(2λ_kM + G)x_k the perturbed roots are the eigenvalues of
///     diag(λ_k) + B,   B_kl = −y_kᴴΔ x_l / d_k   (theory (T15), (T16)):
/// those that B brings together are solved as one block, all others enter in second order. Zero modes, where λ² is what
/// moves, by the quadratic problem of their space.
/// Where the system is the condensed one of `whole`, the repairs are of the matrices of that: all of it in its
/// coordinates, with what massless ones add in second order (roots at infinity).
void state_effects(const System& system, const MatrixSpectrum& spectrum, ModesResult& result, const Condensation* whole = nullptr);
void state_effects(const FirstOrderSystem& system, const MatrixSpectrum& spectrum, ModesResult& result);

}  // namespace gyromode
