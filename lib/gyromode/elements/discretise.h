#pragma once

#include "gyromode/spacecraft/spacecraft.h"
#include "gyromode/system/system.h"

namespace gyromode {

/// How finely.
struct Mesh {
  Index elements = 50;  ///< a cable; a beam has elements · degree, cubic
  /// of the displacement in an element of a cable (Gauss–Lobatto nodes). Errors of frequencies fall as elements^(−2
  /// degree), those of beams as ^(−4)
  Index degree = 1;
};

/// The spacecraft with its booms in finite elements, built from energies (QuadraticEnergy): M q̈ + G q̇ + K q = 0 in
/// turning axes, K with θ3 free. Displacement of the body is eliminated by its being such that the mass centre rests:
/// coordinates θ1, θ2, θ3 and the displacements of the nodes relative to the body, m and rad. Independent of the exact
/// fields, and their check.
System discretise(const Spacecraft& s, const Mesh& mesh);

/// The same with the displacement of the body in it: ζ = body_displacement · q, 3 × n, by which the mass centre rests.
struct Twin {
  System system;
  Matrix body_displacement;
};
Twin twin_of(const Spacecraft& s, const Mesh& mesh);

inline constexpr Index spin_phase_of_twin = 2;  ///< θ3 among its coordinates, in no stored energy

}  // namespace gyromode
