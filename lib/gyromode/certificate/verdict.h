#pragma once

#include "gyromode/certificate/measure.h"
#include "gyromode/spectrum/verdict.h"

#include <string>

namespace gyromode {

/// The verdict on one component.
struct Verdict {
  Stability stability = Stability::stable;
  IndexBalance balance;
  std::vector<bool> unstable_shown;  ///< of every root off the axis: whether it was shown to exist; others are no result
  bool all_shown = false;            ///< whether every root was shown to exist (Exhibits)
  std::string reason;                ///< why the balance is open, for people; empty where it is closed
  std::vector<int> energy_sign;      ///< of every root in the Spectrum: 1, −1, or 0 where it cannot be told
  /// Smallest distance between roots of opposite energy sign relative to the larger; infinite where there is none.
  double gap = 0;
};

/// Energy signs, index balance and verdict on the roots of `s` as measured. Pairs of opposite sign nearer than a
/// backward error of `n ε` moves them are marginal. Of roots that were counted together in a disc its radius becomes
/// the bound in `a`.
Verdict verdict_on(const Impedance& h, const Spectrum& s, Assessment& a);

}  // namespace gyromode
