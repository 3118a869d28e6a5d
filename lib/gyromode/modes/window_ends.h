#pragma once

#include "gyromode/modes/coverage.h"

namespace gyromode {

/// The ends of a window with n₋(H) there: H(0⁺) where a = 0; at an open end just above the last mode, where −ω²M must have taken over.
struct WindowEnds {
  Window window;
  Inertia low, high;
};

/// Whether ω may end a window is a question to H(ω), not to the error bounds of the modes beside it: it serves where the inertia of H(ω) is beyond doubt and is what the modes found below it make it. Else the end is
/// moved outward by growing steps, of some roundings at first and at most 10⁻³ of ω, until both hold. Where no mode is near and H is singular to rounding all the same (ω far below every mode of a singular K), n₋ is
/// taken elsewhere in the gap. What cannot be had so is doubtful, and the end stays where it was.
WindowEnds ends_of(const SolvedSystem& s, const Frequencies& f, const Window& requested);

}  // namespace gyromode
