#pragma once

#include "gyromode/sparse/groups.h"
#include "gyromode/sparse/ritz.h"

#include <vector>

namespace gyromode::sparse {

/// Shapes X = re + j im of roots near ω, n × m. With a partition re has rows in phase alone and im the others.
struct ShapeBlock {
  Vector omega;
  Matrix re, im;
};

/// The shapes separated from each other, ω as the root of Xᴴ(K + jωG − ω²M)X = 0 next to the one given, exact to second
/// order in the error of X; residual, form and error of it. `all`: every root known, ascending, for the gaps.
std::vector<RitzMode> measured(const SparseSystem& system, const Groups& groups, const Norms& norms, const ShapeBlock& shapes,
                               const Vector& all);

}  // namespace gyromode::sparse
