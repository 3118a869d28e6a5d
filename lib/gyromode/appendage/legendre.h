#pragma once

#include "gyromode/lapack/types.h"

namespace gyromode {

/// The deflection of a spinning wire, mass loaded at its tip: Legendre's equation of any degree, real or complex,
///     ((1 − z²) Φ′)′ + 2λ Φ = 0   on [z_a, z_t],   0 ≤ z_a < z_t ≤ 1,   2λ = ν(ν + 1),
/// with z_t = 1/c, c = √(1 + 2μ), μ the tip mass over ρb. At the tip Φ is regular (μ = 0: Φ = P_ν) or Φ′ = cλΦ.
struct WireField {
  double chi = 0;   ///< Φ′/Φ at z_a, by z; infinite where Φ(z_a) = 0
  Index zeros = 0;  ///< of Φ in the open interval (z_a, z_t), by Sturm the number of fixed-root frequencies below
};

/// λ may be negative (ω imaginary). Taylor series from tip to root, in steps that turn the phase by less than π/2, so that sign changes count zeros exactly: no ν is
/// formed, and integer degrees and vanishing tip masses are nothing special. Errors grow as the phase: 1e-15 of χ's scale for ν < 4, 2e-14 at 30, 1e-12 at 100.
WireField wire_field(double lambda, double z_root, double tip_mass_ratio);

}  // namespace gyromode
