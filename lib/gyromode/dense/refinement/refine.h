#pragma once

#include "gyromode/dense/impedance.h"

namespace gyromode::dense {

/// Inverse iteration on the impedance matrix as given, for roots whose residual the solver left above rounding (strong
/// gyroscopic terms, masses or stiffness over many decades). The roots at positions `group` (ascending, close to each
/// other) are replaced in `s` by those of
///     (Yᴴ H(σ) Y) y = δ (Yᴴ H′ Y) y,   Y = H(σ)⁻¹ H′ X orthonormalised,   H′ = 2σM − jG,   ω = σ + δ,
/// with σ moved to the mean of the new roots, until the steps are at rounding. `reach`: how far a root may move in all.
/// Where one would go farther, or two leave the axis (a nearly defective group), the frequencies stay and only the
/// shapes are improved. Returns whether anything changed.
bool refine(const Impedance& h, Spectrum& s, const std::vector<Index>& group, double reach);

}  // namespace gyromode::dense
