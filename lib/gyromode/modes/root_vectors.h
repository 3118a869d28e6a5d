#pragma once

#include "gyromode/modes/matrix_spectrum.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

namespace gyromode {

/// A column of RootVectors, or its conjugate.
struct VectorPlace {
  Index column = 0;
  bool conjugate = false;

  double sign() const { return conjugate ? -1 : 1; }
  VectorPlace conjugated() const { return {column, !conjugate}; }
};

/// A root λ of N(λ) with its right vector x, its left one y (yᴴN(λ) = 0) and its slope yᴴN′(λ)x.
struct RootPlace {
  Complex lambda, slope;
  VectorPlace right, left;
  Index oscillation = -1;  ///< the position in the list of oscillations that the root stands for; −1: none
};

/// All roots λ ≠ 0 of a system of second order, of both signs, or all roots of one of first order, with their vectors.
/// Conjugates share a column: 2m roots of m oscillations need m columns.
class RootVectors {
 public:
  RootVectors(const System& system, const std::vector<Mode>& oscillations, const UnstableRoots& unstable);
  RootVectors(const FirstOrderSystem& system, const std::vector<Mode>& oscillations, const Matrix& zero_shapes);

  Index count() const { return static_cast<Index>(roots_.size()); }
  const RootPlace& root(Index k) const { return roots_[static_cast<std::size_t>(k)]; }
  /// n × 2·columns: the real parts, then the imaginary ones.
  const Matrix& parts() const { return parts_; }
  Index columns() const { return parts_.cols() / 2; }
  /// R V with R = Re Σ x_k y_kᴴ / (−λ_k d_k), d_k the slopes: what these roots leave of K⁻¹; no λ_k may be 0.
  Matrix compliance_times(const Matrix& v) const;

 private:
  RootVectors(Index n, Index columns) : parts_(Matrix::Zero(n, 2 * columns)) {}
  VectorPlace store(const ComplexVector& x);

  std::vector<RootPlace> roots_;
  Matrix parts_;
  Index stored_ = 0;
};

}  // namespace gyromode
