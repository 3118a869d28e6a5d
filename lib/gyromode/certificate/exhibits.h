#pragma once

#include "gyromode/certificate/measure.h"

#include <string>
#include <vector>

namespace gyromode {

/// Which of the roots found were shown to exist.
struct Exhibits {
  bool all = true;
  std::vector<bool> unstable;  ///< of every root off the axis
  std::string reason;          ///< the first root that was not, for people; empty where all were
};

/// Index balance and counts are blind to an exchange: one quadruple for two modes of opposite energy, or for two real
/// pairs, changes nothing in them. So every root has to be shown: either its disc |λ − λ_i| ≤ error bound is a small
/// part of its distance to every other root found and to their mirror images −λ̄, λ̄, to the imaginary axis where it is
/// said to be off it, and to 0; or, of roots nearer to each other than that, their number in a disc around them all is
/// counted by the argument principle. A mode in a disc of its own is on the axis, as its mirror image would be in the
/// same disc.
Exhibits exhibited(const Impedance& h, const Spectrum& s, Assessment& a);

}  // namespace gyromode
