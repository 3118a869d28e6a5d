#pragma once

#include "gyromode/rotor/parts.h"

namespace gyromode {

/// A circle or ring.
struct CrossSection {
  double outer = 0, inner = 0;  ///< diameters, m

  double area() const;           ///< m²
  double second_moment() const;  ///< m⁴, about a diameter; twice that about the axis
  /// κ of Cowper (J. Appl. Mech. 33, 1966): with m = inner/outer,
  /// 6(1 + ν)(1 + m²)² / ((7 + 6ν)(1 + m²)² + (20 + 12ν)m²).
  double shear_coefficient(double poisson) const;
};

}  // namespace gyromode
