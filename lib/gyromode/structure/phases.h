#pragma once

#include "gyromode/base/types.h"

namespace gyromode {

/// Phases d, |d_i| = 1, with d_i d_j = w_ij/w̄_ij along the strongest entries of a complex symmetric W (n × n): a
/// maximum spanning tree of each set connected by entries that stand out, started from the phase that the strongest
/// entry at odds with a two-colouring of the tree (a w_ii, or one that closes an odd cycle) asks for; 1 where there is
/// none. The strength of w_ij is |w_ij|/(ν_i + ν_j) with ν the noise of its row and column; up to 10 it is none.
ComplexVector phases_by_couplings(const ComplexMatrix& w, const Vector& noise);

}  // namespace gyromode
