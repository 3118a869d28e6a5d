#pragma once

#include "gyromode/sparse/groups.h"
#include "gyromode/sparse/stiffness.h"

#include <vector>

namespace gyromode::sparse {

/// The zero roots of a system whose K is singular (theory T10): N spans null(K), NᵀGN has rank 2s; directions N₀ =
/// N a with NᵀGN a = 0 drift, q = N₀t + R with the response R = −K⁺GN₀. Motions of other roots are E-orthogonal to
/// these, E = diag(K, M), and known but for their part of N, which their momentum gives. Empty where K is regular.
struct ZeroMotions {
  Matrix n, mn, gn;          ///< N, MN and GN, n × r: NᵀMN = 1; with a partition every column has entries of one group alone
  std::vector<bool> across;  ///< of every column of N, whether it is in quadrature
  Matrix coupling;           ///< NᵀGN, r × r
  Matrix drift;              ///< N₀, n × (r − 2s), its columns as those of N
  std::vector<bool> drift_across;
  Matrix response;           ///< R = −K⁺GN₀, n × (r − 2s)
  Matrix held;               ///< KR = −GN₀
  Index pairs = 0;           ///< s
  Index negative = 0;        ///< n₋(F), F = N₀ᵀ(M + GᵀK⁺G)N₀
  bool doubtful = false;     ///< a rank, or a sign of F, that rounding may decide otherwise

  Index nullity() const { return n.cols(); }
  Index zero_pairs() const { return nullity() - pairs; }  ///< pairs of zero roots
  /// n₋(H(0⁺)) − n₋(K) = s + n₊(F).
  Index more_at_zero() const { return pairs + drift.cols() - negative; }
};

ZeroMotions zero_motions_of(const SparseSystem& system, const Groups& groups, const StiffnessFactors& stiffness);

/// X of roots ω, re + j im with a partition, re having rows in phase alone and im the others: with the part of N in the
/// group `leading` that its momentum gives it, ω NᵀMX = j NᵀGX, in place of what it has.
void complete(const ZeroMotions& zero, Index leading, const Vector& omega, Matrix& re, Matrix& im);

}  // namespace gyromode::sparse
