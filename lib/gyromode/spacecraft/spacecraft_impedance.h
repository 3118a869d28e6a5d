#pragma once

#include "gyromode/roots/lifted_impedance.h"
#include "gyromode/spacecraft/spacecraft.h"
#include "gyromode/appendage/appendage.h"

#include <memory>

namespace gyromode {

/// The exact impedance of a satellite on (ξ1, ξ2, ξ3, θ1, θ2, φ3) of its mass centre P (SpinOperators) and the
/// coordinates of its appendages; equal cables share their fields.
///
/// Dimensionless: mass in units of the whole, time in 1/spin, length √(J33/m). θ1 and θ2 are divided by √(1 + ω²), and
/// by what the largest inertia asks for.
class SpacecraftImpedance : public LiftedImpedance {
 public:
  explicit SpacecraftImpedance(const Spacecraft& s);

  Index size() const override { return size_; }
  Couplings couplings() const override;
  Lifted at(double omega) const override;
  ComplexMatrix at(Complex omega) const override;
  double rounding(double omega) const override;

  /// Displacement (ζ, θ) of body and reference point, in m and rad, for a null vector at the dimensionless frequency ω.
  ComplexVector body_motion(double omega, const ComplexVector& null_vector) const;
  /// Its body coordinates (ξ, θ1, θ2, φ3) without the scale of the tilt, as appendages meet them.
  ComplexVector body_vector(double omega, const ComplexVector& null_vector) const;
  /// H(ω) on (ζ, θ), in SI, at ω in rad/s.
  ComplexMatrix hub(double omega) const;
  /// H(ω) on (θ1, θ2), everything else eliminated, dimensionless.
  Eigen::Matrix2cd tilt(double omega) const;
  double unit_frequency() const { return spin_; }
  double unit_length() const { return length_; }

  struct Part {
    std::unique_ptr<Appendage> appendage;
    Index first;  // of its coordinates
  };
  const std::vector<Part>& parts() const { return parts_; }

  /// Whether there are infinitely many modes: booms. Without them as many as coordinates.
  bool continuous() const { return continuous_; }
  /// Coordinates that nothing holds: ξ1, ξ2, ξ3, φ3. Of them φ3 is coupled to others through G.
  static std::vector<Index> free_coordinates() { return {0, 1, 2, 5}; }
  static std::vector<Index> cyclic_coordinates() { return {5}; }
  /// Pairs of zero roots beyond spin phase and axial translation: wires hinged on the axis (radius 0) turn about it for
  /// themselves, in all patterns that leave the mass centre and the body's tilt at rest.
  Index neutral_patterns() const { return neutral_patterns_; }

 private:
  double tilt_scale(double omega) const;
  static double tilt_scale(const Complex&) { return 1; }  // analytic
  template <class T>
  void add_all(const T& omega, Lifted& to) const;
  void take(std::unique_ptr<Appendage> appendage);

  double spin_, length_, mass_;
  Eigen::Matrix3d inertia_;  // about P, dimensionless
  std::vector<Part> parts_;
  Index size_ = body_coordinates;
  Index neutral_patterns_ = 0;
  bool continuous_ = false;
  double wire_phase_ = 0, beam_phase_ = 0;  // of the fields, by ω and √(ω + 1)
};

}  // namespace gyromode
