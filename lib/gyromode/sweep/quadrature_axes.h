#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode {

inline constexpr Complex imaginary_unit(0, 1);

/// Axes T = diag(1, −j) of a quadrature partition, in which H is real symmetric; T = 1 without one.
class QuadratureAxes {
 public:
  QuadratureAxes() = default;
  /// Of those coordinates; `in_quadrature` ascending, empty without a partition.
  QuadratureAxes(const std::vector<Index>& coordinates, const std::vector<Index>& in_quadrature);

  /// T* (jG) T of a skew matrix that couples the groups only.
  Matrix crossed(const Matrix& g) const;
  /// T* x of shapes in the columns, and T x.
  ComplexMatrix own(const ComplexMatrix& x) const { return times(x, imaginary_unit); }
  ComplexMatrix given(const ComplexMatrix& own_shapes) const { return times(own_shapes, -imaginary_unit); }
  bool quadrature(Index i) const { return quadrature_[static_cast<std::size_t>(i)]; }

 private:
  ComplexMatrix times(ComplexMatrix x, const Complex& factor) const;

  std::vector<bool> quadrature_;
};

}  // namespace gyromode
