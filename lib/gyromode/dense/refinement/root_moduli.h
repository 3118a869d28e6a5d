#pragma once

#include "gyromode/dense/impedance.h"

#include <optional>
#include <vector>

namespace gyromode::dense {

/// How many roots of det N(λ), N(λ) = K + λG + λ²M, second order, lie at which distance from 0: pairs ±λ between two
/// circles no farther apart than a factor of two.
struct Annulus {
  double inner = 0, outer = 0;
  Index pairs = 0;
};
/// All annuli that hold roots, ascending. Counts are means of λ tr N⁻¹N′ over circles (the argument principle), which
/// every root enters in its own scale, and are rounded: starting points, no proof. `pairs`: how many pairs ±λ ≠ 0 there
/// are. Nothing where the counts do not add up to that.
std::optional<std::vector<Annulus>> root_moduli(const Impedance& h, Index pairs);

}  // namespace gyromode::dense
