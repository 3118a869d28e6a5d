#pragma once

#include "gyromode/dense/impedance.h"

namespace gyromode::dense {

/// One step of Newton's method for many roots at once, second order, without a factorisation: with all roots known but
/// a little wrong, N(λ)⁻¹ = Σ_k x_k y_kᴴ/((λ − λ_k) s_k), s_k = y_kᴴN′(λ_k)x_k, over all 2n roots (those of `s` and
/// their images λ̄, −λ, −λ̄), so that
///     δx_i = −Σ_{k≠i} x_k y_kᴴr_i/((λ_i − λ_k) s_k),   r_i = N(λ_i) x_i.
/// Roots within rounding of λ_i, whose share would not be small, are left out: their span is what is determined. Some
/// products of order n. Frequencies are left as they are: the Rayleigh functional moves them. `modes` and `unstable`:
/// the positions to correct.
void correct_shapes(const Impedance& h, Spectrum& s, const std::vector<Index>& modes, const std::vector<Index>& unstable);

}  // namespace gyromode::dense
