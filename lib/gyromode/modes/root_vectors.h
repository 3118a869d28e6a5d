#pragma once

#include "gyromode/modes/matrix_spectrum.h"
#include "gyromode/system/condensation.h"
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
/// Conjugates share a column: 2m roots of m oscillations need m columns. The vectors are those of the system; or, where
/// it is the condensed one of a whole with massless coordinates, of the whole: slopes are the same.
class RootVectors {
 public:
  /// `whole` is not copied; null: the system is whole.
  RootVectors(const System& system, const std::vector<Mode>& oscillations, const UnstableRoots& unstable,
              const Condensation* whole = nullptr);
  RootVectors(const FirstOrderSystem& system, const std::vector<Mode>& oscillations, const Matrix& zero_shapes);

  Index count() const { return static_cast<Index>(roots_.size()); }
  const RootPlace& root(Index k) const { return roots_[static_cast<std::size_t>(k)]; }
  /// n × 2·columns: the real parts, then the imaginary ones.
  const Matrix& parts() const { return parts_; }
  Index columns() const { return parts_.cols() / 2; }
  /// R V with R = Re Σ x_k y_kᴴ / (−λ_k d_k), d_k the slopes, and what the whole has at infinity: what is left of K⁻¹
  /// without zero modes; no λ_k may be 0.
  Matrix compliance_times(const Matrix& v) const;
  const Condensation* whole() const { return whole_; }

 private:
  RootVectors(Index n, Index columns, const Condensation* whole) : whole_(whole), parts_(Matrix::Zero(n, 2 * columns)) {}
  VectorPlace store(const ComplexVector& x);
  ComplexVector in_whole(Complex lambda, const ComplexVector& x) const { return whole_ ? whole_->expanded(lambda, x) : x; }

  const Condensation* whole_;

  std::vector<RootPlace> roots_;
  Matrix parts_;
  Index stored_ = 0;
};

}  // namespace gyromode
