#pragma once

#include "gyromode/structure/structure.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

#include <string>

namespace gyromode {

/// The system without its couplings up to `tolerance`, with the labels and symmetry errors of the given one: another
/// system, an approximation, of which every question is then asked. The diagonals stay, however small; with tolerance 0
/// nothing is left out. Throws InvalidArgument unless 0 ≤ tolerance ≤ 1, LawBroken where M (I) is not positive definite
/// without them.
System without_ignored_couplings(const System& system, double tolerance);
FirstOrderSystem without_ignored_couplings(const FirstOrderSystem& system, double tolerance);

/// What without_ignored_couplings() leaves out of the system.
IgnoredCouplings ignored_couplings(const System& system, double tolerance);
IgnoredCouplings ignored_couplings(const FirstOrderSystem& system, double tolerance);

}  // namespace gyromode
