#pragma once

#include "gyromode/base/types.h"

#include <string_view>

namespace gyromode {

/// Stability in the sense of theory §5, mildest first; a system is as its worst component.
///   stable                       K ≥ 0: also under damping; its zero modes stay out of the verdict
///   gyroscopically_stabilised    no growing motion, but modes of negative energy, which damping destabilises
///   unknown                      the index balance does not close
///   marginal                     the verdict changes under a backward error of n ε
///   unstable                     divergence or flutter
enum class Stability { stable, gyroscopically_stabilised, unknown, marginal, unstable };
std::string_view to_string(Stability s);

/// n₋(K) = k_r + 2k_c + 2k₋ + n₋(F)  (theory (T12)). In `negative_energy` a pair that cannot be told apart counts one.
struct IndexBalance {
  Index negative = 0;         ///< n₋(K)
  Index real_pairs = 0;       ///< k_r, divergence
  Index quadruples = 0;       ///< k_c, flutter
  Index negative_energy = 0;  ///< k₋
  Index zero = 0;             ///< pairs of zero roots
  Index zero_negative = 0;    ///< n₋(F), the part of n₋(K) that the zero roots take
  bool closed = true;         ///< whether the equation holds with roots shown to exist

  /// Of two systems side by side.
  IndexBalance& operator+=(const IndexBalance& other);
};

}  // namespace gyromode
