#pragma once

#include "gyromode/modes/modes.h"
#include "gyromode/spectrum/counted_spectrum.h"

namespace gyromode {

/// Throws InvalidArgument unless the options can be asked of a model with so many roots: a window, at least one mode;
/// of infinitely many a window with two ends or `lowest`.
void require_options(const ModesOptions& options);

/// The modes of a window, or the lowest so many, of a counted spectrum. Throws InvalidArgument where all of infinitely
/// many are asked for.
ModesResult modes_of(const CountedSpectrum& spectrum, const ModesOptions& options);

/// How many there are in a window.
CountResult count_of(const CountedSpectrum& spectrum, const Window& requested);

}  // namespace gyromode
