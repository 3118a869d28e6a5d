#pragma once

#include "gyromode/impedance/blocks.h"

#include <functional>
#include <vector>

namespace gyromode {

/// The impedance in its blocks, evaluated for all of them at once.
struct BlockedImpedance {
  const LiftedImpedance& impedance;
  std::vector<Block> blocks;

  explicit BlockedImpedance(const LiftedImpedance& i) : impedance(i), blocks(blocks_of(i)) {}
};

/// How many roots of block `block` are below ω, as an ever growing integer: J(ω) where all energy is positive; with modes of negative energy, of which each takes one away where it is
/// passed, J and twice the number of those already passed.
using GrowingCount = std::function<Index(Index block, double omega, Index count)>;

/// An interval that holds `roots` roots of one block (of one copy of it), by its count at the ends. More than one only where bisection came down to rounding.
struct Bracket {
  Index block = 0;
  double lo = 0, hi = 0;
  Index below = 0;   ///< growing count at lo
  Index roots = 1;
  Index change = 1;      ///< of J itself from lo to hi: each root of positive energy adds one, each of negative energy takes one away
  double nearest_lo = 0, nearest_hi = 0;  ///< modulus of the block's eigenvalue nearest to zero at the ends
};

/// Bisection of the count until every bracket holds one root, or neighbours that rounding does not tell apart.
std::vector<Bracket> isolate(const BlockedImpedance& h, double a, double b, const GrowingCount& growing);

}  // namespace gyromode
