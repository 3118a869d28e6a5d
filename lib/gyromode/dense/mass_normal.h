#pragma once

#include "gyromode/spectrum/unstable_roots.h"
#include "gyromode/base/types.h"
#include "gyromode/structure/inertia_of_k.h"

#include <memory>
#include <optional>
#include <utility>

namespace gyromode::dense {

/// K = F Fᵀ of a positive definite K (n × n), F lower triangular, from a Cholesky factor of the scaled K: small
/// eigenvalues of a graded K keep their digits.
class StiffnessFactor {
 public:
  /// Of a K of which that is known, its factor among it where it has one. Nothing where K is not positive definite, or
  /// where it cannot be told from a semidefinite one.
  static std::optional<StiffnessFactor> of(const Matrix& k, const StiffnessInertia& known);

  /// diag(d) F.
  Matrix scaled_rows(const Vector& d) const;
  /// s := F⁻ᵀ s, from s = Fᵀq to q: the same as f and L one after the other, L⁻ᵀ f⁻ᵀ, in one solve.
  void to_physical(MatrixSpan s) const;

 private:
  explicit StiffnessFactor(std::shared_ptr<const PositiveFactor> factor) : factor_(std::move(factor)) {}

  std::shared_ptr<const PositiveFactor> factor_;
};

/// Coordinates in which the mass matrix of a group is the unit matrix: q = D L⁻ᵀ z with D M D = L Lᵀ, D the
/// power-of-two scaling to unit diagonal (so that mixed units cost no digits).
class MassNormal {
 public:
  /// m: n × n, positive definite, lower triangle read. Throws NotConverged where the factorisation fails all the same.
  explicit MassNormal(const Matrix& m);

  Index size() const { return l_.rows(); }

  /// L⁻¹ D K D L⁻ᵀ for symmetric K (n × n), symmetric to the last bit.
  Matrix stiffness(const Matrix& k) const;
  /// L⁻¹ D G D L⁻ᵀ for skew G, skew to the last bit.
  Matrix gyroscopic(const Matrix& g) const;
  /// L₁⁻¹ D₁ B D₂ L₂⁻ᵀ for B coupling this group (rows) to `other` (columns).
  Matrix coupling(const Matrix& b, const MassNormal& other) const;
  /// f = L⁻¹ D F with K = F Fᵀ, so that the normalised stiffness is f fᵀ (theory (T5)); lower triangular.
  Matrix stiffness_root(const StiffnessFactor& k) const;
  /// z := D L⁻ᵀ z, columns from normal to physical coordinates.
  void to_physical(MatrixSpan z) const;
  void to_physical(ComplexMatrix& z) const;
  void to_physical(UnstableRoots& roots) const;
  /// q := Lᵀ D⁻¹ q, the reverse.
  void to_normal(MatrixSpan q) const;

 private:
  Vector scale_;
  Matrix l_;
};

}  // namespace gyromode::dense
