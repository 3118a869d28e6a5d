#pragma once

#include "gyromode/dense/impedance.h"

#include <optional>

namespace gyromode::dense {

/// Right and left null vectors of N(λ) = K + λG + λ²M for λ at or beside a root, unit length: N(λ)X ≈ 0, YᴴN(λ) ≈ 0, by
/// inverse iteration on the equilibrated matrix.
struct NullPair {
  ComplexVector right, left;
};
NullPair null_pair(const Impedance& h, Complex lambda);

/// tr N(λ)⁻¹N′(λ): the logarithmic derivative of det N at λ, second order. Not finite where N(λ) is singular to the
/// last bit.
Complex logarithmic_slope(const Impedance& h, Complex lambda);

/// The number of roots of det N in the disc |λ − centre| < radius, with multiplicity, by the argument principle: the
/// mean of (λ − centre) tr N⁻¹N′ over equidistant points of the circle, doubled until it is an integer to 1 %. Nothing
/// where 256 points do not settle it: a root is near the circle. Relative to the distance q of a root from the circle
/// (as a ratio of radii) m points leave an error q^m.
std::optional<DiscCount> roots_in_disc(const Impedance& h, Complex centre, double radius);

}  // namespace gyromode::dense
