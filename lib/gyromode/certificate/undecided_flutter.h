#pragma once

#include "gyromode/certificate/assess.h"

namespace gyromode {

/// Refines the unstable roots on the matrices as given, and returns flutter whose growth rate a backward error could undo to the axis: as two modes in `s`, which
/// is then measured again (`a`). Returns whether there was any.
bool return_undecided_flutter(const Impedance& h, dense::Spectrum& s, Assessment& a);

}  // namespace gyromode
