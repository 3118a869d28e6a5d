#pragma once

#include "gyromode/sparse/sparse_system.h"

namespace gyromode::sparse {

/// What rounding of the entries of H(ω) does to its form: 4ε |X|ᵀ(|K| + ω|G| + ω²|M|)|X|, each |A| bounded by its
/// largest sum of a row over roots of diagonal entries, |X|ᵀ|A||X| ≤ c Σ d_i|X_i|², c = max_i Σ_k |a_ik|/√(d_i d_k),
/// with d the diagonal of K or M.
class RoundingSizes {
 public:
  explicit RoundingSizes(const SparseSystem& system);
  double of(const ComplexVector& shape, double omega) const;

 private:
  Vector k_, m_;  // diagonals, positive
  double ck_ = 0, cg_ = 0, cm_ = 0;
};

}  // namespace gyromode::sparse
