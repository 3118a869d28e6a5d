#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/sparse/krylov.h"
#include "gyromode/sparse/ritz.h"
#include "gyromode/spectrum/window.h"

#include <functional>
#include <memory>
#include <vector>

namespace gyromode::sparse {

/// A growing motion as a search leaves it.
struct RitzUnstable {
  Complex lambda;
  double residual = 0;     ///< ‖N(λ)X‖₂ / ((‖K‖ + |λ|‖G‖ + |λ|²‖M‖)‖X‖₂)
  double error_bound = 0;  ///< on |δλ|, to first order
  ComplexVector shape;
};

/// |X|ᵀ|A||X| of a (skew-)symmetric A by its lower triangle: what rounding of its entries is relative to.
double size_of(const SparseMatrix& lower, const ComplexVector& x);

/// Modes of a sparse system about one shift: a Krylov space that grows until what is wanted of it has converged.
class Search {
 public:
  /// At σ ≥ 0; 0: about K, which must be regular.
  Search(const SparseSystem& system, ShiftedImpedance& impedance, const Norms& norms, double sigma);

  /// What is known by now.
  struct Found {
    std::vector<RitzMode> modes;         ///< ascending, those below the bound asked for
    std::vector<RitzUnstable> unstable;  ///< all that the space holds
  };
  /// Grows until `enough` says so of what is found below `below`, or the space is `largest` wide, or nothing new comes.
  Found until(const std::function<bool(const Found&)>& enough, double below, Index largest, const Progress& progress);

  Index negative_at_shift() const { return negative_; }  ///< n₋(H(σ))
  static bool converged(const RitzMode& m);

 private:
  Found found(double below) const;

  const SparseSystem& system_;
  Norms norms_;
  Index negative_ = 0;
  std::unique_ptr<Subspace> v_;
  std::unique_ptr<Krylov> krylov_;
};

}  // namespace gyromode::sparse
