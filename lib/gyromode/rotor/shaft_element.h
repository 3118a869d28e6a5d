#pragma once

#include "gyromode/rotor/cross_section.h"

namespace gyromode {

/// A piece of shaft that one element stands for.
struct ShaftPiece {
  Material material;
  double length = 0;                             ///< m
  CrossSection lower, upper;                     ///< at its ends, linear between
  ShaftTheory theory = ShaftTheory::timoshenko;  ///< shear and rotary inertia
  std::optional<double> shear_coefficient;       ///< κ; left out: Cowper's

  CrossSection at(double z) const;  ///< at height z above the lower end
};

/// Matrices of an element in one plane, of the displacements and slopes (u, θ) at its lower and its upper end, 4 × 4,
/// with u' = θ + shear angle. Motions are interpolated by those of the unloaded piece, shear and taper included, so
/// that the stiffness is exact for statics (for a uniform piece: Nelson, J. Mech. Design 102, 1980).
struct ShaftElement {
  Matrix mass;       ///< ∫ρA NᵤᵀNᵤ + ∫ρI NᵩᵀNᵩ, the latter but for euler
  Matrix rotary;     ///< ∫ρI NᵩᵀNᵩ: the gyroscopic coupling of the planes is 2Ω of it
  Matrix stiffness;  ///< of bending and shear
  Matrix geometric;  ///< ∫Nᵤ'ᵀNᵤ': times a tension it adds to the stiffness
};
ShaftElement shaft_element(const ShaftPiece& piece);

}  // namespace gyromode
