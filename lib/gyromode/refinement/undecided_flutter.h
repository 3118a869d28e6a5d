#pragma once

#include "gyromode/certificate/measure.h"
#include "gyromode/dense/impedance.h"

namespace gyromode {

/// Refines the unstable roots that are not known well enough on the matrices as given, and returns flutter that a
/// backward error could undo, or whose disc meets the axis, to it: as two modes in `s`, which is then measured again
/// (`a`).
void return_undecided_flutter(const dense::Impedance& h, Spectrum& s, Assessment& a);

}  // namespace gyromode
