#pragma once

#include "gyromode/roots/divergence.h"

#include <optional>

namespace gyromode {

/// A root off the real axis of one block near the seed λ, or nothing: secant steps on the bordered determinant g(z) of
/// the block, z = −jλ,
///     [A(z) u; vᴴ 0] (x, g) = (0, 1),   g(z) = −1/(vᴴ A(z)⁻¹ u),
/// u and v the singular vectors of the seed. Accepted where the steps settle at rounding, near the seed, farther from
/// the axes than rounding of a nearly double root moves it, and the block there is singular to rounding. A real λ stays
/// real (divergence).
std::optional<UnstableRoot> unstable_root(const BlockedImpedance& h, Index block, Complex seed);

/// Fills residual and error of a root: g of unstable_root() there, and its slope by central differences.
void measure(const BlockedImpedance& h, UnstableRoot& root);

}  // namespace gyromode
