#pragma once

#include "gyromode/spectrum/inertia.h"
#include "gyromode/sweep/quadrature_axes.h"
#include "gyromode/system/spin_family.h"

#include <vector>

namespace gyromode {

/// The Hermitian pencil K₀ − νB of a connected part of a family, ν = Ω², B = m²M − jmG₁ − K₂: real symmetric by the
/// signs of a quadrature partition, or complex. Rows and columns are `coordinates` of the family.
class SpeedPencil {
 public:
  SpeedPencil(const SpinFamily& family, double multiple, const std::vector<Index>& coordinates, const std::vector<Index>& in_quadrature,
              bool partition);

  /// A root ν, real or not, with its vector in all coordinates of the part, in the axes of the family.
  struct Root {
    Complex nu;
    ComplexVector shape;
  };
  /// Roots with ν ≠ 0; those at infinity are left out.
  std::vector<Root> roots() const;
  /// Inertia of K₀ − νB.
  Inertia inertia_at(double nu) const;
  /// A root improved by inverse iteration, with the Rayleigh quotient of it.
  Root polished(const Root& root) const;
  /// ‖(K₀ − νB)X‖ over the norms, and what rounding and that residual leave open of ν.
  double residual(const Root& root) const;
  double error_of(const Root& root) const;
  /// Whether a real root is so far out that rounding of B does not tell it from infinity, where B is singular; and
  /// below which speed it cannot be.
  bool is_at_infinity(const Root& root) const;
  double least_speed(const Root& root) const;
  /// n₋(K₀), and at 0⁺, where the null space of K₀ has left zero.
  Index negative_at_zero() const;
  const std::vector<Index>& coordinates() const { return coordinates_; }

 private:
  double uncertainty(double nu, const ComplexVector& own) const;
  double error_of_inverse(const Root& root) const;
  ComplexVector times(double nu, const ComplexVector& own) const;

  std::vector<Index> coordinates_;
  QuadratureAxes axes_;
  bool real_ = false;
  Matrix stiffness_, re_, im_;  // K₀, Re B, Im B (0 × 0 where real)
};

}  // namespace gyromode
