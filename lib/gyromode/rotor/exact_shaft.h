#pragma once

#include "gyromode/rotor/parts.h"

#include <Eigen/Core>

namespace gyromode {

/// A uniform piece of a Rayleigh shaft: EI z⁗ − ρI(z̈″ − 2jΩż″) − N z″ + ρA z̈ = 0 for z = x + jy in fixed axes, under
/// tension N.
struct ExactPiece {
  double length = 0;        ///< l, m
  double bending = 0;       ///< EI, N m²
  double rotary = 0;        ///< ρI, kg m
  double line_density = 0;  ///< ρA, kg/m
  double tension = 0;       ///< N, N
  double speed = 0;         ///< Ω, rad/s, of its spool

  /// Of a section that has one diameter, between two places of it. @throws NotApplicable of another theory or a taper
  static ExactPiece of(const ShaftSection& section, const Material& material, double length, double speed, double tension);

  /// The dynamic stiffness of z e^{jωt}, ω of any sign (positive: forward for Ω > 0), on z and z′ at both ends, real
  /// symmetric 4 × 4: forces that hold the ends moving so. From the transfer matrix, the exponential of the field's
  /// equations as a power series. ω may be complex.
  template <class T>
  Eigen::Matrix<T, 4, 4> dynamic_stiffness(const T& omega) const;

  /// Whether no motion with clamped ends has a frequency up to ω: the trigonometric wave number times l is at most 3,
  /// and the lowest such motion has more than π (it is 4.73 of a beam, and tends to π as tension grows).
  bool clamped_above(double omega) const;
};

}  // namespace gyromode
