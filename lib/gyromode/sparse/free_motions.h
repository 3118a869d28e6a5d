#pragma once

#include "gyromode/sparse/groups.h"
#include "gyromode/sparse/stiffness.h"

#include <vector>

namespace gyromode::sparse {

/// What a system does without being held, known and not looked for: translations that keep to themselves (`t`), and
/// the zero roots of a system whose K is singular (theory T10): N spans null(K), NᵀGN has rank 2s; directions N₀ =
/// N a with NᵀGN₀ = 0 drift, q = N₀t + R with the response R = −K⁺GN₀. Motions of other roots are E-orthogonal to
/// these, E = diag(K, M), and known but for their part of N, which their momentum gives.
struct FreeMotions {
  Matrix n, mn, gn;          ///< N, MN and GN, n × r: NᵀMN = 1; with a partition every column has entries of one group alone
  std::vector<bool> across;  ///< of every column of N, whether it is in quadrature
  std::vector<bool> drifts;  ///< of every column of N, whether it is one of N₀: NᵀG of it is zero to rounding
  Matrix drift;              ///< N₀, n × (r − 2s), its columns as those of N
  std::vector<bool> drift_across;
  Matrix response;        ///< R = −K⁺GN₀, n × (r − 2s)
  Matrix held;            ///< KR = −GN₀
  Index pairs = 0;        ///< s
  Index negative = 0;     ///< n₋(F), F = N₀ᵀ(M + GᵀK⁺G)N₀
  bool rigid = false;     ///< null(K) is spanned by motions of a rigid body that the system is known to have
  bool doubtful = false;  ///< a rank, or a sign of F, that rounding may decide otherwise

  Matrix t, mt, kt;  ///< T, MT and KT, n × any number, TᵀMT = 1, as translations of the system; columns as those of N
  std::vector<bool> t_across;

  bool any() const { return nullity() + t.cols() > 0; }
  Index nullity() const { return n.cols(); }
  Index zero_pairs() const { return nullity() - pairs; }  ///< pairs of zero roots
  /// n₋(H(0⁺)) − n₋(K) = s + n₊(F).
  Index more_at_zero() const { return pairs + drift.cols() - negative; }
};

FreeMotions free_motions_of(const SparseSystem& system, const Groups& groups, const StiffnessFactors& stiffness);

/// X of roots ω, re + j im with a partition, re having rows in phase alone and im the others: with the part of N in the
/// group `leading` that its momentum gives it, ω NᵀMX = j NᵀGX, in place of what it has.
void complete(const FreeMotions& free, Index leading, const Vector& omega, Matrix& re, Matrix& im);

}  // namespace gyromode::sparse
