#pragma once

#include "gyromode/certificate/assess.h"
#include "gyromode/spectrum/verdict.h"

#include <string>

namespace gyromode {

/// The verdict on one component.
struct Verdict {
  Stability stability = Stability::stable;
  IndexBalance balance;
  std::vector<bool> unstable_shown;  ///< of every root off the axis: whether it was shown to exist; others are no result
  bool all_shown = false;            ///< whether every root was shown to exist (Exhibits)
  std::string reason;  ///< why the balance is open, for people; empty where it is closed
  std::vector<int> energy_sign;  ///< of every root in the Spectrum: 1, −1, or 0 where it cannot be told
  /// Smallest distance between roots of opposite energy sign relative to the larger; infinite where there is none.
  double gap = 0;
};

/// Energy signs, index balance and verdict. Pairs of opposite sign nearer than a backward error of `n ε` moves them, and flutter with a growth rate below
/// it, are marginal; such flutter is returned to the axis: two modes of sign 0 in `s` (and `a` measured again).
Verdict judge(const Impedance& h, dense::Spectrum& s, Assessment& a);

}  // namespace gyromode
