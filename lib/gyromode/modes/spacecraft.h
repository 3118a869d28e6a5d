#pragma once

#include "gyromode/modes/count.h"
#include "gyromode/modes/modes.h"
#include "gyromode/spacecraft/spacecraft.h"

namespace gyromode {

/// Modes of a spacecraft with exact booms in a window, or the lowest so many: none missing where `complete`. Spin phase and axial translation (ω = 0) and the tilt of the momentum axis
/// (ω = Ω) are listed as rigid-body modes; translation across the axis is no mode of a body free in space and is not.
/// Throws InvalidArgument for an open window without `lowest`, as there are infinitely many modes, and NotApplicable for a method of matrix models.
ModesResult find_modes(const Spacecraft& spacecraft, const ModesOptions& options = {});

/// By the counts at the ends of the window alone.
CountResult count_modes(const Spacecraft& spacecraft, const Window& window);

/// Which of (ζ, θ) move in phase, which in quadrature, and which do not meet.
Structure analyse(const Spacecraft& spacecraft);

/// H(ω) on (ζ, θ) at the mass centre of the complete satellite, in N and N m per m and rad, ω > 0.
ComplexMatrix impedance_at(const Spacecraft& spacecraft, double omega);

}  // namespace gyromode
