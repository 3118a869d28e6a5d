#pragma once

#include "gyromode/sparse/groups.h"
#include "gyromode/sparse/inverse.h"
#include "gyromode/sparse/shifted.h"
#include "gyromode/sparse/stiffness.h"

#include <memory>

namespace gyromode::sparse {

/// With a partition, M₁ẍ + Bẏ + K₁x = 0, M₂ÿ − Bᵀẋ + K₂y = 0 and K₁ > 0:  −A⁻² on u = (x, ẏ), self-adjoint in
/// E = diag(K₁, M₂); θ = 1/ω², negative for divergence. One solve with K₂ and one with K₁ (theory sparse §2):
///     y = K₂⁻¹(Bᵀx − M₂ẏ),   −A⁻²u = (K₁⁻¹(M₁x + By), −y)
class InverseOfBlocks : public Inverse {
 public:
  /// `first`: the block of K that is positive definite; it plays the part of K₁.
  InverseOfBlocks(const SparseSystem& system, const Groups& groups, const StiffnessFactors& stiffness, Index first);

  Index length() const override { return system_.size(); }
  States start(const Matrix& shapes) const override;
  States apply(const States& u) const override;
  Matrix inner(const Matrix& x) const override;
  void settle(States& u) const override;
  double square(double theta) const override { return 1 / theta; }
  Index leading_group() const override { return first_; }
  Matrix shapes(const Matrix& states) const override;
  Matrix states(const Matrix& shapes) const override;

 private:
  // States have x above and ẏ below.
  const SparseSystem& system_;
  const Groups& groups_;
  const StiffnessFactors& stiffness_;
  Index first_, leading_;
  SparseMatrix k_, m_first_, m_second_, coupling_;  // K₁, M₁, M₂ by lower triangles, B
};

/// With a partition and K₁ > 0:  (A² + σ²)⁻¹ on u = (x, ẏ), self-adjoint in E = diag(K₁, M₂); θ = 1/(σ² − ω²), by one
/// solve with H*(σ) (theory sparse §4):
///     [K₁ − σ²M₁, σB; σBᵀ, K₂ − σ²M₂] (x, z) = (−M₁f₁, (Bᵀf₁ − M₂f₂)/σ),   ẏ = σz
class InverseAtShift : public Inverse {
 public:
  InverseAtShift(const SparseSystem& system, const Groups& groups, std::shared_ptr<const ShiftedFactor> impedance, Index first);

  Index length() const override { return system_.size(); }
  States start(const Matrix& shapes) const override;
  States apply(const States& u) const override;
  Matrix inner(const Matrix& x) const override;
  void settle(States& u) const override;
  bool rough_products() const override;
  double square(double theta) const override { return impedance_->shift * impedance_->shift - 1 / theta; }
  Matrix shapes(const Matrix& states) const override { return states; }
  Index leading_group() const override { return first_; }

 private:
  const SparseSystem& system_;
  const Groups& groups_;
  std::shared_ptr<const ShiftedFactor> impedance_;
  Index first_;
  SparseMatrix coupling_;
  SparseMatrix energy_;  // E
};

/// Of any G, K > 0:  A⁻¹ on (q, q̇), skew-adjoint in E = diag(K, M); θ = ∓j/ω, by one solve with K (theory sparse §3):
///     A⁻¹(q, q̇) = (−K⁻¹(Mq̇ + Gq), q)
class InverseOfMotion : public Inverse {
 public:
  InverseOfMotion(const SparseSystem& system, const StiffnessFactors& stiffness) : system_(system), stiffness_(stiffness) {}

  Index length() const override { return 2 * system_.size(); }
  bool skew() const override { return true; }
  States start(const Matrix& shapes) const override;
  States apply(const States& u) const override;
  Matrix inner(const Matrix& x) const override;
  void settle(States& u) const override;
  double square(double theta) const override { return 1 / (theta * theta); }
  Matrix shapes(const Matrix& states) const override { return states.topRows(system_.size()); }

 private:
  const SparseSystem& system_;
  const StiffnessFactors& stiffness_;
};

/// Of any G, K > 0:  (A² + σ²)⁻¹ on (q, q̇), self-adjoint in E = diag(K, M); θ = 1/(σ² − ω²), every one double:
///     H(σ) w = −(Mf₂ + Gf₁ + jσMf₁),   (A² + σ²)⁻¹f = (Im w / σ, Re w)
class InverseOfMotionAtShift : public Inverse {
 public:
  InverseOfMotionAtShift(const SparseSystem& system, std::shared_ptr<const ShiftedFactor> impedance)
      : system_(system), impedance_(std::move(impedance)) {}

  Index length() const override { return 2 * system_.size(); }
  States start(const Matrix& shapes) const override;
  States apply(const States& u) const override;
  Matrix inner(const Matrix& x) const override;
  void settle(States& u) const override;
  bool rough_products() const override;
  double square(double theta) const override { return impedance_->shift * impedance_->shift - 1 / theta; }
  bool motions() const override { return false; }
  Matrix shapes(const Matrix& states) const override;

 private:
  const SparseSystem& system_;
  std::shared_ptr<const ShiftedFactor> impedance_;
};

}  // namespace gyromode::sparse
