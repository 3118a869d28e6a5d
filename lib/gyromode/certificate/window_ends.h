#pragma once

#include "gyromode/spectrum/counted_spectrum.h"

namespace gyromode {

/// The ends of a window with n₋(H) there: H(0⁺) where a = 0; at an open end above all roots, where −ω²M must have taken
/// over.
struct WindowEnds {
  Window window;
  Inertia low, high;
};

/// Whether ω may end a window is a question to H(ω), not to the error bounds of the modes beside it: it serves where
/// the inertia of H(ω) is beyond doubt and, where all roots are known, is what those below it make it. Else the end is
/// moved outward by growing steps, of some roundings at first and at most 10⁻³ of ω, until it serves. Where no root is
/// near and H is singular to rounding all the same (ω far below every root of a singular K), n₋ is taken elsewhere in
/// the gap. What cannot be had so is doubtful, and the end stays where it was.
WindowEnds ends_of(const CountedSpectrum& s, const Window& requested);

/// A window with the roots in it, and perhaps some outside.
struct FilledWindow {
  Window window;
  RootRange found;
};

/// [a, b) with b above the `lowest`-th root from a on that is no rigid-body one, in the middle of the gap that follows;
/// roots that coincide with it come along. Throws InvalidArgument where there are fewer within reach, TooLarge where
/// more are asked for than the engine lists at a time.
FilledWindow lowest_window(const CountedSpectrum& s, Index lowest, const Window& requested, const Progress& progress = {});

}  // namespace gyromode
