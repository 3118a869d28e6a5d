#pragma once

#include "gyromode/roots/blocks.h"

#include <functional>
#include <vector>

namespace gyromode {

/// The impedance in its blocks, evaluated for all of them at once. The impedance must outlive it.
struct BlockedImpedance {
  const LiftedImpedance& impedance;
  std::vector<Block> blocks;

  explicit BlockedImpedance(const LiftedImpedance& i) : impedance(i), blocks(blocks_of(i)) {}
  explicit BlockedImpedance(const LiftedImpedance&&) = delete;
};

/// How many roots of block `block` are below ω, as an ever growing integer: J(ω) where all energy is positive; with
/// modes of negative energy, of which each takes one away where it is passed, J and twice the number of those already
/// passed.
using MonotoneCount = std::function<Index(Index block, double omega, Index count)>;

/// An interval that holds `roots` roots of one block (of one copy of it), by its count at the ends. More than one only
/// where bisection came down to rounding.
struct Bracket {
  Index block = 0;
  double lo = 0, hi = 0;
  Index roots = 1;
  Index count = 0;                    ///< J itself at lo
  Index change = 1;                   ///< of J from lo to hi: each root of positive energy adds one, each of negative energy takes one away
  double value_lo = 0, value_hi = 0;  ///< crossing() at the ends, for one root
};

/// The eigenvalue of a block that passes zero at the one root of a bracket, made positive below the root and negative
/// above it. Sorted eigenvalues keep their places: with J at the lower end it is the (J − Σ poles_below)-th that falls
/// through zero where the energy is positive, the one before that rises where it is negative.
double crossing(const BlockState& state, Index count_lo, Index change);
Index crossing_position(const BlockState& state, Index count_lo, Index change);

/// Bisection of the count until every bracket holds one root, or neighbours that rounding does not tell apart. Brackets
/// are handed over as they are found, their lower ends never falling, until one is answered with false; then the result
/// is false.
bool isolate(const BlockedImpedance& h, double a, double b, const MonotoneCount& growing, const std::function<bool(const Bracket&)>& found);

}  // namespace gyromode
