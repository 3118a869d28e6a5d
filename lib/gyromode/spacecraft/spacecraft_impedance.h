#pragma once

#include "gyromode/impedance/lifted_impedance.h"
#include "gyromode/spacecraft/spacecraft.h"

#include <memory>

namespace gyromode {

/// The exact impedance of a satellite on (ξ1, ξ2, ξ3, θ1, θ2, φ3) of its mass centre P (Turning) and the coordinates of its appendages; equal cables share their fields.
///
/// Dimensionless: mass in units of the whole, time in 1/spin, length √(J33/m). θ1 and θ2 are divided by √(1 + ω²).
class SpacecraftImpedance : public LiftedImpedance {
 public:
  explicit SpacecraftImpedance(const Spacecraft& s);

  Index size() const override { return size_; }
  Lifted at(double omega) const override;
  ComplexMatrix at(Complex omega) const override;
  double rounding(double omega) const override;

  /// Displacement (ζ, θ) of body and reference point, in m and rad, for a null vector at the dimensionless frequency ω.
  ComplexVector body_motion(double omega, const ComplexVector& null_vector) const;
  double unit_frequency() const { return spin_; }
  double unit_length() const { return length_; }

  struct Part {
    std::unique_ptr<Appendage> appendage;
    Index first;  // of its coordinates
  };
  const std::vector<Part>& parts() const { return parts_; }

  /// Cables on the spin axis (radius 0) leave the hub alone in plane: zero modes beyond those of the body.
  Index cables_on_axis() const { return cables_on_axis_; }

 private:
  template <class T>
  void add_all(const T& omega, Lifted& to) const;
  void take(std::unique_ptr<Appendage> appendage);

  double spin_, length_, mass_;
  Eigen::Matrix3d inertia_;  // about P, dimensionless
  std::vector<Part> parts_;
  Index size_ = body_coordinates;
  Index cables_on_axis_ = 0;
  double longest_wave_ = 0;  // κ-like measures for rounding()
};

}  // namespace gyromode
