#pragma once

#include "gyromode/certificate/assess.h"
#include "gyromode/dense/refinement/characteristic_products.h"

namespace gyromode {

/// Moves every λ to the root of YᴴN(λ)X = 0 near it, N(λ) = K + λG + λ²M: two steps of Newton's method at most, each a small part of |λ| that makes the residual smaller. A real λ stays real.
void correct_unstable(dense::UnstableRoots& roots, const dense::CharacteristicProducts& of_right);
/// What Assessment says of roots off the axis.
Assessment::Unstable measure_unstable(const Impedance& h, const dense::UnstableRoots& roots, const dense::CharacteristicProducts& of_right);

/// For roots off the axis at the positions `group`, near each other: a bound on their distance from as many true roots, to first order, from their spans: as of a cluster of modes (Assessment), with the smallest singular
/// value of [Y_iᴴN′(λ)X_k].
double span_bound(const Impedance& h, const dense::UnstableRoots& roots, const std::vector<Index>& group);

}  // namespace gyromode
