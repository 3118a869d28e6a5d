#pragma once

#include "gyromode/dense/quadrature/quadrature.h"

namespace gyromode::dense {

/// The quadrature class with both stiffness blocks indefinite, by the n × n real matrix P of (T6).
///
/// With u = (x, ẏ), v = (ẋ, y): Σ v̇ = −E_u u, Σᵀ u̇ = E_v v, Σ = [1 b; 0 −1] = Σ⁻¹, E_u = diag(k₁, 1), E_v = diag(1,
/// k₂), so that
///     ü = −P u,   P = Σ⁻ᵀ E_v Σ⁻¹ E_u,   E_u P = (Σ⁻¹E_u)ᵀ E_v (Σ⁻¹E_u) symmetric,
/// and energy = ½(uᵀE_u u + vᵀE_v v), the two halves equal in the mean of a mode: uᵀE_u u has its energy sign. Groups
/// of close roots are projected on the pencil (E_u P, E_u), which leaves coinciding roots of one sign real. Roots below
/// 1 % of the largest frequency would carry the error ε‖P‖/ω; they are projected, (U ᵀΣV, UᵀE_uU, VᵀE_vV), and solved
/// again by themselves.
QuadratureModes product_modes(const QuadratureForm& form);

}  // namespace gyromode::dense
