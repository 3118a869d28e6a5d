#pragma once

#include "gyromode/sparse/factor.h"
#include "gyromode/sparse/groups.h"

#include <memory>
#include <vector>

namespace gyromode::sparse {

/// H(σ), factored.
class ShiftedFactor {
 public:
  double shift = 0;
  Index negative = 0;  ///< n₋(H(σ)), arbitrary where σ is that of a mode to rounding
  /// How far from singular: the least |xᴴHx| over |x|ᵀ|H||x| that inverse iteration finds.
  double margin = 0;
  /// H(σ)⁻¹R, n × m.
  ComplexMatrix solve(const ComplexMatrix& r) const;
  /// H*⁻¹R of H* = T⁻¹HT, T = diag(1, −j); with a partition. n × m
  Matrix solve_star(const Matrix& r) const;

 private:
  friend class ShiftedImpedance;
  std::shared_ptr<SymmetricFactor> factor_;
  const Groups* groups_ = nullptr;
};

/// H(ω) = K − ω²M + jωG in real arithmetic: with a partition H* = T⁻¹HT, T = diag(1, −j), real symmetric of order n;
/// without one [Re H, −Im H; Im H, Re H] of order 2n, whose every eigenvalue is double. One pattern, ordered and
/// analysed once.
class ShiftedImpedance {
 public:
  ShiftedImpedance(const SparseSystem& system, const Groups& groups);

  /// Of its pattern, for estimates: nothing is factored.
  std::unique_ptr<const SymmetricFactor> analysed() const;
  /// H(σ), σ ≥ 0, factored, to count and to solve with. The last two are kept.
  std::shared_ptr<const ShiftedFactor> at(double sigma) const;

 private:
  void build() const;
  SparseMatrix values_at(double omega) const;

  const SparseSystem& system_;
  const Groups& groups_;
  // Built when first needed.
  mutable SparseMatrix pattern_;           // of H* or the embedding, lower triangle; its values are 0
  mutable std::vector<double> k_, m_, g_;  // what K, M and G have at every entry of the pattern: value = k − ω²m + ωg
  mutable std::vector<int> order_;
  mutable SparseMatrix metric_;                               // M, or M twice
  mutable std::vector<std::shared_ptr<ShiftedFactor>> kept_;  // the older first
};

}  // namespace gyromode::sparse
