#pragma once

#include "gyromode/roots/isolate.h"

namespace gyromode {

/// A root of one block, to full precision.
struct Root {
  Index block = 0;
  double omega = 0;
  double lo = 0, hi = 0;  ///< counts on both sides prove it there: the narrowest that rounding leaves beyond doubt
  double value = 0;       ///< μ, the eigenvalue of the block that vanishes, as computed at ω
  double slope = 0;       ///< μ′ = xᴴ (dH/dω) x
  /// of xᴴ(2ωM − jG)x of the whole system, by the count: an eigenvalue falls through zero where it is positive
  /// (docs/theory.md (T2a)); 0 where several roots
  int energy_sign = 1;
  ///< of both signs share the bracket
  double error = 0;      ///< on |δω|: (|μ| + rounding) / |μ′|
  bool rigid = false;    ///< named by the caller: known by construction
  ComplexVector vector;  ///< x in the coordinates of the Lifted matrix, 2-norm 1
};

/// The root (or roots) of a bracket, on the eigenvalue that changes sign: inverse quadratic interpolation, bisection
/// where it does not pay (Chandrupatla 1997), the counts keeping the bracket. One Root a root and copy.
std::vector<Root> converge(const BlockedImpedance& h, const Bracket& bracket);

}  // namespace gyromode
