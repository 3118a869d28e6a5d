#pragma once

#include "gyromode/lapack/types.h"

namespace gyromode {

/// Dynamic stiffness at the clamped end of a cantilever of bending stiffness 1: ψ⁗ = κψ, ψ″(l) = 0, ψ‴(l) = −εκψ(l), ε the tip mass over the line density, in m.
/// d is conjugate to (ψ(0), ψ′(0)): d·(ψ, ψ′) = (ψ‴, −ψ″). d → −κ [[l + ε, l²/2 + εl], [·, l³/3 + εl²]] for κ → 0.
Eigen::Matrix2d cantilever_stiffness(double kappa, double length, double tip_length);

/// How many clamped frequencies, κ_n = ρω_n²/EI, are below κ ≥ 0.
Index cantilever_poles_below(double kappa, double length, double tip_length);

}  // namespace gyromode
