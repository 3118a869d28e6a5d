#pragma once

#include "gyromode/modes/result.h"

#include <array>

namespace gyromode {

enum class CountStatus { exact, signed_only, doubtful };
std::string_view word(CountStatus status);

/// How many modes a window holds, by factorisations at its ends (theory (T9), (T10)).
struct CountResult {
  Window window;                    ///< what was used: an endpoint on a mode is moved outward
  Window requested;
  std::optional<Index> count;       ///< modes in [a, b), zero modes included where a = 0; nothing where only the signed count is known
  Index signed_count = 0;           ///< modes of positive minus modes of negative energy
  Index zero = 0;                   ///< zero modes in the window
  std::array<Index, 2> negative{};  ///< n₋(H(a)), n₋(H(b)); H(0⁺) where a = 0
  CountStatus status = CountStatus::doubtful;
};

/// The system is solved as well: an indefinite K needs its negative-energy modes, and the solution shows where an endpoint is on a mode. `exact` where the index
/// balance closes and the count agrees with the modes found.
CountResult count_modes(const System& system, const Window& window);
CountResult count_modes(const FirstOrderSystem& system, const Window& window);

}  // namespace gyromode
