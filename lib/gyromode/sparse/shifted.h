#pragma once

#include "gyromode/sparse/factor.h"
#include "gyromode/sparse/sparse_system.h"
#include "gyromode/structure/structure.h"

#include <memory>
#include <optional>

namespace gyromode::sparse {

/// H(ω) = K − ω²M + jωG in real arithmetic: with a partition H* = T⁻¹HT, T = diag(1, −j), real symmetric of order n;
/// without one [Re H, −Im H; Im H, Re H] of order 2n, whose every eigenvalue is double. One pattern, ordered and
/// analysed once.
class ShiftedImpedance {
 public:
  ShiftedImpedance(const SparseSystem& system, const Structure& structure);

  bool quadrature() const { return quadrature_; }
  /// Of every coordinate, whether it is in quadrature; all false without a partition.
  const std::vector<bool>& in_quadrature() const { return across_; }

  /// n₋(H(ω)), by the signs of pivots; arbitrary where ω is that of a mode to rounding.
  Index negative_at(double omega) const;
  /// n₋(K), at ω = 0.
  Index negative_of_stiffness() const;

  /// Factorises H(σ), or K where σ = 0, to solve with, unless that is done; n₋ as it comes along.
  Index factor(double sigma);
  double shift() const { return sigma_; }
  /// Whether H(σ) came out singular, so that it cannot be solved with.
  bool singular() const { return solver_ && solver_->singular(); }
  /// H(σ)⁻¹R, n × m.
  ComplexMatrix solve(const ComplexMatrix& r);
  double megabytes() const;

 private:
  SparseMatrix at(double omega) const;

  const SparseSystem& system_;
  bool quadrature_ = false;
  std::vector<bool> across_;
  SparseMatrix pattern_;           // of H* or the embedding, lower triangle; its values are 0
  std::vector<double> k_, m_, g_;  // what K, M and G have at every entry of the pattern: value = k − ω²m + ωg
  std::vector<int> order_;
  std::unique_ptr<SymmetricFactor> solver_;
  mutable std::unique_ptr<SymmetricFactor> counter_;
  double sigma_ = 0;
  std::optional<Index> negative_;  // of H(σ), once it is factored
};

}  // namespace gyromode::sparse
