#pragma once

#include "gyromode/modes/modes.h"
#include "gyromode/spacecraft/spacecraft.h"

namespace gyromode {

/// Which of (ζ, θ) move in phase, which in quadrature, and which do not meet.
Structure analyse(const Spacecraft& spacecraft);

/// H(ω) on (ζ, θ) at the mass centre of the complete satellite, in N and N m per m and rad, ω > 0.
ComplexMatrix impedance_at(const Spacecraft& spacecraft, double omega);

}  // namespace gyromode
