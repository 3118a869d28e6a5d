#pragma once

#include "gyromode/spectrum/result.h"
#include "gyromode/system/system.h"

#include <array>
#include <optional>

namespace gyromode {

/// Of the modes given (ascending), the two neighbours of opposite energy sign nearest to each other, rad/s: flutter
/// begins where such a pair meets. Nothing where all energies have one sign.
std::optional<std::array<double, 2>> nearest_opposite_pair(const std::vector<Mode>& modes);

/// The eigenvalue of the resting problem K x = λ M x nearest to zero, of those that are not zero: `zero` is the
/// dimension of null(K) (ModesResult::stiffness): divergence begins, or ends, where one passes zero. Nothing where all
/// are zero.
std::optional<double> stiffness_margin(const System& system, Index zero);

}  // namespace gyromode
