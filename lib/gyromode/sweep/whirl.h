#pragma once

#include "gyromode/base/types.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode {

/// Which way a station goes round its orbit, seen with the rotation of the shaft.
enum class Whirl {
  forward,    ///< with it
  backward,   ///< against it
  mixed,      ///< some stations this way, others that way
  planar,     ///< along a line
  degenerate  ///< double modes that no symmetry parts, and at rest: any of the others, by combination
};
std::string_view to_string(Whirl whirl);

/// Two coordinates that are displacements of one place across the axis, along x and y.
struct OrbitCoordinates {
  Index x = 0;            ///< position of the displacement along x
  Index y = 0;            ///< along y
  std::string name = {};  ///< of the place, for people; may be empty
  double along = 0;       ///< m, its position along the axis; 0 where it is not known
};

/// The ellipse that a place goes round in a motion Re(X e^{jωt}).
struct Orbit {
  double major = 0;        ///< its longer half axis
  double minor = 0;        ///< the shorter one: positive forward, negative backward
  double inclination = 0;  ///< rad, of the longer one from x towards y, in (−π/2, π/2]

  /// Of an aspect ratio below 10⁻⁶: planar. `spin` of the shaft, whose sign says which way is forward.
  Whirl whirl(double spin = 1) const;
};
Orbit orbit_of(const ComplexVector& shape, const OrbitCoordinates& place);

/// Of a motion Re(X e^{jωt}), ω > 0, of places that turn about z at `spin`: x = cos ωt, y = sin ωt is forward for spin
/// ≥ 0, backward else. An orbit of an aspect ratio below 10⁻⁶ is a line; places that move less than 10⁻⁶ of the largest
/// are passed over. Nothing where there are no places, or where none moves.
std::optional<Whirl> whirl_of(const ComplexVector& shape, const std::vector<OrbitCoordinates>& places, double spin = 1);

/// A part of a motion in axes that do not turn.
struct FixedAxesPart {
  double omega = 0;  ///< rad per unit of time; positive: goes round with the rotation, negative: against it
  double share = 0;  ///< of the squares of all parts, 0 … 1
};
/// Of a motion Re(X e^{jωt}) in axes that turn at `spin` about z: of x + jy = p e^{jωt} + q̄ e^{−jωt} the first part has
/// the frequency ω + Ω in fixed axes, the second Ω − ω. Parts below 10⁻⁶ of the largest are left out; none where no
/// place moves.
std::vector<FixedAxesPart> in_fixed_axes(const ComplexVector& shape, double omega, double spin,
                                         const std::vector<OrbitCoordinates>& places);

}  // namespace gyromode
