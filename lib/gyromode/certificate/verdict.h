#pragma once

#include "gyromode/certificate/assess.h"

#include <string>
#include <string_view>

namespace gyromode {

/// Stability in the sense of theory §5, mildest first; a system is as its worst component.
///   stable                       K ≥ 0: also under damping; its zero modes stay out of the verdict
///   gyroscopically_stabilised    no growing motion, but modes of negative energy, which damping destabilises
///   unknown                      the index balance does not close
///   marginal                     the verdict changes under a backward error of n ε
///   unstable                     divergence or flutter
enum class Stability { stable, gyroscopically_stabilised, unknown, marginal, unstable };
std::string_view word(Stability s);

/// n₋(K) = k_r + 2k_c + 2k₋ + n₋(F)  (theory (T12)). In `negative_energy` a pair that cannot be told apart counts one.
struct IndexBalance {
  Index negative = 0;         ///< n₋(K)
  Index real_pairs = 0;       ///< k_r, divergence
  Index quadruples = 0;       ///< k_c, flutter
  Index negative_energy = 0;  ///< k₋
  Index zero = 0;             ///< pairs of zero roots
  Index zero_negative = 0;    ///< n₋(F), the part of n₋(K) that the zero roots take
  bool closed = true;

  IndexBalance& operator+=(const IndexBalance& other);
};

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
