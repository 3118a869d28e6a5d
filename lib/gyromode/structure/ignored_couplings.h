#pragma once

#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

#include <string>

namespace gyromode {

/// Couplings that somebody asked to leave out: a_ij, i ≠ j, with |a_ij| ≤ tolerance · max |a|, in each of M, G, K (I, G) by itself.
struct IgnoredCouplings {
  double tolerance = 0;
  double largest = 0;  ///< of those left out, |a_ij| / max |a|; 0 where none was small enough
};

/// The system without its couplings up to `tolerance`, with the labels and symmetry errors of the given one: another system, an approximation, of which every question is then asked.
/// The diagonals stay, however small; with tolerance 0 nothing is left out. Throws InvalidArgument unless 0 ≤ tolerance ≤ 1, LawBroken where M (I) is not positive definite
/// without them.
System without_ignored_couplings(const System& system, double tolerance);
FirstOrderSystem without_ignored_couplings(const FirstOrderSystem& system, double tolerance);

/// What without_ignored_couplings() leaves out of the system.
IgnoredCouplings ignored_couplings(const System& system, double tolerance);
IgnoredCouplings ignored_couplings(const FirstOrderSystem& system, double tolerance);
/// "couplings up to 0.01 of the largest entry of their matrix are left out, as asked: the largest of them is 0.0025".
std::string in_words(const IgnoredCouplings& ignored);

}  // namespace gyromode
