#pragma once

#include "gyromode/base/rounding.h"
#include "gyromode/certificate/measure.h"

#include <vector>

namespace gyromode {

/// Energy signs of the modes of one component (theory §5).
struct EnergySigns {
  std::vector<int> sign;      ///< of every root: 1, −1, or 0 where it cannot be told
  Index undecided_pairs = 0;  ///< pairs of sign 0: one + and one −
  /// Smallest distance between roots of opposite sign relative to the larger; 0 where a pair is undecided, infinite
  /// where there is none.
  double gap = infinity;
};

/// A simple root has the sign of its form. Roots that a backward error of n ε can bring together have theirs as a
/// cluster: by the signature of the form on their shapes, else by the change of n₋(H) across it.
EnergySigns energy_signs(const Impedance& h, const Spectrum& s, const Assessment& a);

}  // namespace gyromode
