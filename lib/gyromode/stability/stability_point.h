#pragma once

#include "gyromode/spectrum/result.h"

#include <string>

namespace gyromode {

/// The verdict at one point of parameter space.
struct StabilityPoint {
  bool law_kept = true;                      ///< false: no such model (a law is broken); `reason` says which
  Stability stability = Stability::unknown;  ///< the verdict
  IndexBalance balance;                      ///< what it rests on
  double growth_rate = 0;                    ///< the largest, 1/s
  std::string reason;                        ///< why there is no such model, or no verdict; for people

  /// Whether there is a verdict at all.
  bool decided() const { return law_kept && stability != Stability::unknown; }
  /// Whether a verdict changes between two decided points: another verdict, or other numbers of divergent, fluttering
  /// and negative-energy motions, where both balances are closed. Of a balance that is open only the verdict is known.
  bool differs(const StabilityPoint& other) const;
};

/// What the modes of a system say.
StabilityPoint stability_point(const ModesResult& result);

}  // namespace gyromode
