#pragma once

#include "gyromode/motion/modal_part.h"

namespace gyromode {

/// Estimates of |δω| on the matrices as given, entry by entry, of frequencies that are roots of XᴴH(ω)X = 0
/// (Assessment): what rounding of that sum leaves, and, to second order, what the shapes are wrong by,
///     C_kk/|f_k| + Σ_{l≠k} min(c, c²/|ω_l ∓ ω_k|),   c = C_lk/√|f_l f_k|,   f = Xᴴ(2ωM − jG)X,
///     C_lk = |X_lᴴH(ω_k)X_k| + ε |X_l|ᵀ(|K| + ω_k|G| + ω_k²|M|)|X_k|,
/// with the sum over the modes at ω_l and their mirror images at −ω_l, conjugate shapes. Where stiffnesses are far
/// apart these are smaller by orders than bounds from norms; never above them.
Vector frequency_errors(const ComponentMatrices& m, const ComplexMatrix& shapes, const Vector& omega, const Vector& form,
                        const Vector& bounds);

}  // namespace gyromode
