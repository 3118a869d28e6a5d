#pragma once

#include "gyromode/sweep/large_family.h"
#include "gyromode/system/spin_family.h"

#include <vector>

namespace gyromode {

/// A large family on the space that shapes given to it span: a family of small matrices in coordinates y, q = Vy with
/// VᵀSV = 1, S = K₀ + τM. V is real, so that with X it spans X̄, whose frequency is −ω.
class ProjectedFamily {
 public:
  /// `reach`: τ = reach² or more, rad per unit of time.
  ProjectedFamily(const LargeFamily& family, double reach);

  /// Takes n × m shapes into the space. What is in it to 10⁻⁶ already is not added.
  void add(const ComplexMatrix& shapes);

  Index order() const { return basis_.cols(); }
  /// Its matrices, order() × order().
  const SpinFamily& family() const { return reduced_; }
  /// y of n × m shapes: their part in the space.
  ComplexMatrix coordinates(const ComplexMatrix& shapes) const;
  /// Rows of V, of chosen coordinates.
  Matrix rows(const std::vector<Index>& chosen) const { return basis_(chosen, Eigen::all); }

 private:
  Matrix weighted(const Matrix& x) const;
  void add_to_family(const Matrix& more);

  const LargeFamily& family_;
  double tau_;
  Matrix basis_, weighted_basis_;  // V and SV
  SpinFamily reduced_;
};

}  // namespace gyromode
