#pragma once

#include "gyromode/certificate/window_ends.h"

namespace gyromode {

/// The count of modes in the window of `ends` by theory (T9), (T10): independent of the modes found but for their
/// energy signs. Zero modes included.
Index counted_in(const CountedSpectrum& s, const WindowEnds& ends);

/// Whether that count is what was found. Where roots were not isolated by counts the count is checked inside the window
/// as well: between runs of modes of one sign, and at the widest gaps, n₋(H) must have changed by the signs found
/// below. Frequencies in the unit of the spectrum; `inside` are the roots found.
Coverage coverage_of(const CountedSpectrum& s, const WindowEnds& ends, const std::vector<CountedRoot>& inside);

}  // namespace gyromode
