#pragma once

#include "gyromode/modes/spacecraft_spectrum.h"

namespace gyromode {

/// Whether the body takes no part in a mode: exactly 0 in a pattern without it; rounding where the pattern shares a
/// block with it (wires on the axis).
bool body_at_rest(const Root& r);

/// Gives a mode its shape on (ζ, θ) and the displacement of the points of the outlines; in a mode of the booms alone
/// the largest displacement is 1.
void add_shape(const SpacecraftSpectrum& s, const Root& r, Mode& mode);

/// Points and lines of the booms, in the axes and from the origin of the model.
std::vector<ModelOutline> outlines_of(const SpacecraftSpectrum& s);

}  // namespace gyromode
