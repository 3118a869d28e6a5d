#pragma once

#include "gyromode/appendage/pole.h"

#include <vector>

namespace gyromode {

/// How a cantilever of bending stiffness 1 answers the loads 1 and s along itself, ψ⁗ = κψ + load, ψ(0) = ψ′(0) = 0,
/// ψ″(l) = 0, ψ‴(l) = −ε(κψ + load)(l), with ε the tip mass over the line density, in m: C = ∫ (1, s)ᵀ ψ (ds + ε at the
/// tip), symmetric 2 × 2, for each load. Any κ, real or complex: κ = 0 is the static answer.
FieldResponse<double> cantilever_answer(double kappa, double length, double tip_length);
FieldResponse<Complex> cantilever_answer(Complex kappa, double length, double tip_length);

/// That answer ψ at `stations` in [0, l] to the loads (first, second), for pictures: to some eight digits.
Vector cantilever_shape(double kappa, double length, double tip_length, double first, double second, const std::vector<double>& stations);

/// How many clamped frequencies, κ_n = ρω_n²/EI, are below κ ≥ 0: one in every interval [nπ, (n + 1)π) of κ^¼l, on a
/// side that the sign of `phi` of the FieldResponse tells.
Index cantilever_poles_below(double kappa, double length, double phi);

}  // namespace gyromode
