#pragma once

#include "gyromode/roots/isolate.h"

namespace gyromode {

/// A root off the real axis: e^{λt}, λ = growth + j omega, both in units of the impedance; omega = 0 for divergence.
struct UnstableRoot {
  Index block = 0;
  double growth = 0, omega = 0;
  Index copies = 1;
  /// |μ / (λ μ′)|, μ the singular value of the block that vanishes: how far the root is, relative to |λ|, as far as μ
  /// tells
  double residual = 0;
  double error = 0;  ///< on |δλ|, to first order: (|μ| + rounding) / |μ′|
};

/// Real roots λ = σ > 0 of one block, ascending.
///
/// A system with real M, G, K has a real H(−jσ) = σ²M + σG + K, and the determinant of a block of its Lifted form, a
/// power of the φ of its fields times det H, is real up to one constant phase. Its sign is taken at samples of σ over
/// all decades; where it changes between two of them at which it is beyond rounding, an odd number of roots is between
/// them, and bisection comes down to one. So no odd one is missed, however slow; two in one interval of samples are.
std::vector<UnstableRoot> divergences(const BlockedImpedance& h, Index block);

}  // namespace gyromode
