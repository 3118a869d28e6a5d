#pragma once

#include "gyromode/base/types.h"

#include <string>

namespace gyromode {

/// A perfectly flexible, inextensible wire boom, hinged at its root, radial and taut by the spin alone.
struct Cable {
  double azimuth = 0;       ///< rad, from axis 1
  double radius = 0;        ///< m, of the root from axis 3, ≥ 0
  double height = 0;        ///< m, of the root above the origin, along axis 3
  double length = 0;        ///< m, > 0
  double line_density = 0;  ///< kg/m, > 0
  double tip_mass = 0;      ///< kg, ≥ 0

  double reach() const { return radius + length; }                  ///< radius of the tip, m
  double mass() const { return line_density * length + tip_mass; }  ///< with its tip mass, kg
  /// S = ∫ r dm, kg m. The tension at the root is spin² S.
  double first_moment() const;
  /// ∫ r² dm, kg m².
  double second_moment() const;
  Eigen::Vector3d direction() const;  ///< from root to tip, unit vector
  /// Whether both have the same field: radius, length, density and tip mass.
  bool same_field(const Cable& other) const;
};

/// An Euler–Bernoulli boom along axis 3, clamped at its root, with a point mass at its tip. It carries no axial load,
/// and its inertia about its own axis is left out.
struct Beam {
  double root_height = 0;                ///< m, above the origin
  bool upward = true;                    ///< direction of axis 3, or against it
  double length = 0;                     ///< m, > 0
  double line_density = 0;               ///< kg/m, > 0
  double bending_stiffness[2] = {0, 0};  ///< N m², for motion along axes 1 and 2, > 0
  double tip_mass = 0;                   ///< kg, ≥ 0

  double mass() const { return line_density * length + tip_mass; }  ///< with its tip mass, kg
  double way() const { return upward ? 1 : -1; }                    ///< 1 upward, −1 downward
};

/// A point mass held to the body by three springs along the body axes. An infinite stiffness is a rigid connection in
/// that direction.
struct SpringMass {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< m, from the origin, where it sits while the satellite spins steadily
  double mass = 0;                                      ///< kg, > 0
  Eigen::Vector3d stiffness = Eigen::Vector3d::Zero();  ///< N/m, > 0 or infinite
};

/// A point of a boom or a sprung mass.
struct BoomPoint {
  /// Of which kind of part.
  enum class Part { cable, beam, mass };
  Part part = Part::cable;   ///< kind of part
  Index number = 1;          ///< from 1, in the order of the model
  double along = 1;          ///< from root, 0, to tip, 1; of no meaning for a mass
  std::string name() const;  ///< "cable1@0.5", "mass2"
};

}  // namespace gyromode
