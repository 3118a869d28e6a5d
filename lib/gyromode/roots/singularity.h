#pragma once

#include "gyromode/roots/isolate.h"

namespace gyromode {

/// The matrix of one block at complex ω, rows and columns with entries above 1 divided by the largest: what singular
/// means may not depend on the factors of fields, nor on the growth of inertia. Small rows stay small, for rounding of
/// the entries is relative to 1. Positive factors: the phase of the determinant is as it was.
ComplexMatrix equilibrated_block(const BlockedImpedance& h, const Block& block, const Complex& omega);

/// Smallest singular value over the largest.
double relative_singularity(const ComplexMatrix& a);

}  // namespace gyromode
