#pragma once

#include "gyromode/appendage/hub_matrix.h"
#include "gyromode/appendage/legendre.h"

namespace gyromode {

/// A perfectly flexible, inextensible wire boom, hinged at its root, radial and taut by the spin alone.
struct Cable {
  double azimuth = 0;       ///< rad, from axis 1
  double radius = 0;        ///< m, of the root from axis 3, > 0
  double height = 0;        ///< m, of the root above O, along axis 3
  double length = 0;        ///< m, > 0
  double line_density = 0;  ///< kg/m, > 0
  double tip_mass = 0;      ///< kg, ≥ 0

  double mass() const { return line_density * length + tip_mass; }
  /// ∫ r dm of the radial wire about axis 3, kg m. The tension at the root is spin² times it.
  double first_moment() const;
};

/// What a cable does to the body at a given spin (rad/s), exactly: the forces of its field, without a discretisation.
class CableImpedance {
 public:
  CableImpedance(const Cable& cable, double spin);

  /// H_cable(ω): − force and moment on the body for unit root motions e^{jωt}, with the static second-order terms of the root tension. Hermitian.
  HubMatrix at(double omega) const;
  /// n₋ of the impedance of the cable with its root held: how many fixed-root frequencies, in plane and out of plane, are below ω > 0.
  Index fixed_root_negative(double omega) const;

 private:
  struct Fields {
    WireField in_plane, out_of_plane;
  };
  Fields fields(double omega) const;

  Cable cable_;
  double spin_;
  double tension_;          // at the root, N
  double reach_;            // b = radius + length
  double tip_mass_ratio_;   // μ
  double unit_;             // bc, of z
  double z_root_;           // z_a
};

}  // namespace gyromode
