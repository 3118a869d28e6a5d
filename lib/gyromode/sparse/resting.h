#pragma once

#include "gyromode/sparse/groups.h"
#include "gyromode/sparse/ritz.h"
#include "gyromode/sparse/free_motions.h"

namespace gyromode::sparse {

/// n₋(K − μM) of what is not left out as free, by the blocks of a partition, in a fraction of the memory that factors
/// take; arbitrary where μ is ω² of a mode at rest to rounding. With γ ≥ ‖M^−½GM^−½‖ and μ = σ² + γσ it is at least
/// n₋(H(σ)) (theory T17).
Index negative_at_rest(const SparseSystem& system, const Groups& groups, double mu);

/// ω² of the modes at rest in the space of some shapes, ascending, without those of null(K): each is not below the true
/// one.
Vector resting_squares(const SparseSystem& system, const FreeMotions& free, const std::vector<RitzMode>& shapes);

}  // namespace gyromode::sparse
