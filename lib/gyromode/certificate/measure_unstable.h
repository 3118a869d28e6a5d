#pragma once

#include "gyromode/certificate/measure.h"

namespace gyromode {

/// What Assessment says of roots off the axis.
Assessment::Unstable measure_unstable(const Impedance& h, const UnstableRoots& roots, const CharacteristicProducts& of_right);

/// For roots off the axis at the positions `group`, near each other: a bound on their distance from as many true roots,
/// to first order, from their spans: as of a cluster of modes (Assessment), with the smallest singular value of
/// [Y_iᴴN′(λ)X_k].
double span_bound(const Impedance& h, const UnstableRoots& roots, const std::vector<Index>& group);

}  // namespace gyromode
