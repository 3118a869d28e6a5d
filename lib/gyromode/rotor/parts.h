#pragma once

#include "gyromode/base/types.h"

#include <optional>
#include <string>

namespace gyromode {

/// What a shaft or a disc is made of.
struct Material {
  std::string name;    ///< as the parts call it
  double young = 0;    ///< E, Pa, > 0
  double shear = 0;    ///< shear modulus, Pa, > 0
  double density = 0;  ///< kg/m³, > 0

  double poisson() const { return young / (2 * shear) - 1; }  ///< ν of an isotropic material
};

/// What a shaft element holds of shear and of the rotary inertia of its slices.
enum class ShaftTheory {
  timoshenko,  ///< both
  rayleigh,    ///< rotary inertia
  euler        ///< neither; the gyroscopic term of the slices stays
};

/// A length of shaft, with a linear taper where the diameters at its ends differ.
struct ShaftSection {
  std::string material;                          ///< name of one
  double length = 0;                             ///< m, > 0
  double outer_diameter[2] = {0, 0};             ///< m, at its lower and its upper end, > 0
  double inner_diameter[2] = {0, 0};             ///< m, ≥ 0, below the outer ones
  Index elements = 1;                            ///< of equal length; more where discs and bearings part them
  ShaftTheory theory = ShaftTheory::timoshenko;  ///< of its elements
  std::optional<double> shear_coefficient;       ///< κ; left out: Cowper's for a circle or tube
  std::string spool;                             ///< name of the spool it belongs to; empty: the only one
};

/// A disc by its width and diameters.
struct DiscGeometry {
  std::string material;       ///< name of one
  double width = 0;           ///< m, > 0
  double inner_diameter = 0;  ///< m, ≥ 0
  double outer_diameter = 0;  ///< m, above the inner one
};

/// A rigid disc that turns with the shaft; by mass and inertias, or by geometry.
struct Disc {
  double position = 0;                   ///< m, along the rotor
  double offset = 0;                     ///< m, of its centre beyond the position where it is fixed to the shaft
  double mass = 0;                       ///< kg
  double polar_inertia = 0;              ///< kg m², about the axis
  double diametral_inertia = 0;          ///< kg m², about a diameter, of its centre
  std::optional<DiscGeometry> geometry;  ///< gives mass and inertias where it is there
  std::string spool;                     ///< as of a section
};

/// A mass without inertia.
struct PointMass {
  double position = 0;  ///< m
  double mass = 0;      ///< kg, ≥ 0
  std::string spool;    ///< as of a section
};

/// Springs between the rotor and the ground, or two spools: kxx x + kxy y along x, kxy x + kyy y along y, and likewise
/// moments by tilts. Infinite ones pin. With a housing the springs lead to it, and it stands on springs of its own.
struct Bearing {
  double position = 0;      ///< m
  double kxx = 0;           ///< N/m, along x
  double kyy = 0;           ///< N/m, along y
  double kxy = 0;           ///< N/m, of either direction by the other
  double tilt_xx = 0;       ///< N m/rad, of rotations about x
  double tilt_yy = 0;       ///< N m/rad, of rotations about y
  double tilt_xy = 0;       ///< N m/rad, of either by the other
  double housing_mass = 0;  ///< kg; with the next two 0: there is no housing
  double housing_kxx = 0;   ///< N/m, between housing and ground along x
  double housing_kyy = 0;   ///< N/m, along y
  std::string spool;        ///< that it carries
  std::string to;           ///< the spool it stands on; empty: the ground

  /// Whether it stands in a housing.
  bool has_housing() const { return housing_mass != 0 || housing_kxx != 0 || housing_kyy != 0; }
};

/// Coordinates that do not move.
struct Support {
  double position = 0;  ///< m
  bool x = false;       ///< whether the displacement along x is held
  bool y = false;       ///< along y
  bool tilt_x = false;  ///< the rotation about x
  bool tilt_y = false;  ///< about y
  std::string spool;    ///< as of a section
};

/// One of the shafts that turn about the common axis.
struct Spool {
  std::string name;        ///< as its parts call it
  double speed_ratio = 1;  ///< its speed over that of the rotor
  double start = 0;        ///< m, the lower end of its first section
};

}  // namespace gyromode
