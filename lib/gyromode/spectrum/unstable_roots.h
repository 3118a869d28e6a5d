#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode {

/// Roots off the imaginary axis, one of each pair ±σ (Im λ = 0) and quadruple ±σ ± jω: Re λ > 0, Im λ ≥ 0.
struct UnstableRoots {
  std::vector<Complex> lambda;
  ComplexMatrix right;  ///< n × roots: X of X e^{λt}
  ComplexMatrix left;   ///< n × roots: Y of Y e^{−λ̄t}, so that YᴴN(λ) = 0, N(λ) = K + λG + λ²M, as N(λ)ᴴ = N(−λ̄)

  Index count() const { return static_cast<Index>(lambda.size()); }
  UnstableRoots() = default;
  /// Room for `count` roots of order n; set() fills it.
  UnstableRoots(Index n, Index count) : lambda(static_cast<std::size_t>(count)), right(n, count), left(n, count) {}
  void set(Index k, Complex root, const ComplexVector& x, const ComplexVector& y);
  void add(Complex root, const ComplexVector& x, const ComplexVector& y);
  bool divergent(Index k) const { return lambda[static_cast<std::size_t>(k)].imag() == 0; }
  /// Those at the positions `kept`.
  UnstableRoots chosen(const std::vector<Index>& kept) const;
};

}  // namespace gyromode
