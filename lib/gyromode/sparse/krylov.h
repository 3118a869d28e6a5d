#pragma once

#include "gyromode/sparse/groups.h"
#include "gyromode/sparse/subspace.h"

#include <functional>
#include <vector>

namespace gyromode::sparse {

/// H(σ)⁻¹ of a shift σ ≥ 0; at σ = 0 K⁻¹.
struct Resolvent {
  double shift = 0;
  std::function<ComplexMatrix(const ComplexMatrix&)> solve;
};

/// Block Krylov space of the motion (q, q̇), A(q, q̇) = (q̇, −M⁻¹(Gq̇ + Kq)), gathered into a Subspace of shapes: of (A² +
/// σ²)⁻¹ at a frequency σ > 0, by one solve with H(σ), or of A⁻¹ at σ = 0, by one with K (theory sparse §2–4). Roots
/// near σ come first.
///
///     (A − jσ) w = f:   H(σ) q = −(M f₂ + G f₁ + jσ M f₁),   (A² + σ²)⁻¹ f = Im w / σ = (Im q / σ, Re q)
///     A⁻¹ f:            K q = −(M f₂ + G f₁),                A⁻¹ f = (q, f₁)
///
/// States are kept by their coefficients in the subspace and orthonormal in the norm σ²‖q‖²_M + ‖q̇‖²_M.
class Krylov {
 public:
  Krylov(const SparseSystem& system, const Groups& groups, const Resolvent& resolvent, Subspace& subspace)
      : system_(system), groups_(groups), resolvent_(resolvent), v_(subspace) {}

  /// Goes on from what H(σ)⁻¹ makes of shapes, n × m, beside the states there are.
  void start(const Matrix& shapes);
  /// Goes on from those motions alone, n × m: the subspace is another one than before.
  void restart(const Matrix& displacement, const Matrix& velocity);

  /// One block more. @returns false where nothing new comes
  bool step();

 private:
  // Coefficients of displacement and velocity of states, one below the other, each with as many rows as the subspace
  // has.
  Matrix stacked(const Matrix& q, const Matrix& v) const;
  bool orthonormalise(Matrix& state) const;
  Matrix displacement(const Matrix& state) const { return state.topRows(state.rows() / 2) / scale_; }
  Matrix velocity(const Matrix& state) const { return state.bottomRows(state.rows() / 2); }
  static Matrix extended(const Matrix& state, Index rows);

  const SparseSystem& system_;
  const Groups& groups_;
  const Resolvent& resolvent_;
  Subspace& v_;
  double scale_ = 0;
  std::vector<Matrix> states_;
  bool ended_ = false;
};

}  // namespace gyromode::sparse
