#pragma once

#include "gyromode/sparse/sparse_system.h"

#include <array>
#include <optional>
#include <vector>

namespace gyromode {

/// What a coordinate of a mesh is: the number of its node, and 0, 1, 2 for a displacement along x, y, z.
struct MeshCoordinate {
  long node = 0;
  int direction = 0;
};

/// A symmetry of a mesh that reverses the sense of its spin.
struct MeshSymmetry {
  enum class Kind { mirror, half_turn };
  Kind kind = Kind::mirror;
  std::array<double, 3> direction{};  ///< normal of the mirror plane, or axis of the half-turn; across the axis of the spin
};

/// An export of a finite-element code: M and K (which holds the stress and the softening of the spin) in axes that turn
/// with the structure.
struct StructureParts {
  SparseMatrix mass, stiffness;                  ///< lower triangles
  std::vector<MeshCoordinate> coordinates;       ///< n
  double spin = 0;                               ///< Ω, rad per unit of time
  std::array<double, 3> axis{0, 0, 1};           ///< of the spin; any length but zero
  std::vector<std::array<double, 3>> positions;  ///< of the node of every coordinate; empty: not known
  std::optional<MeshSymmetry> symmetry;          ///< one that it has; else coordinate planes and half-turns about coordinate axes are tried
  SparseMatrix stiffness_at_rest;                ///< K of the mesh at rest, likewise; 0 × 0: how K depends on the spin is not known
};

/// The same at another spin: what the spin does to K, its stress and its softening, goes with Ω². Of parts with a spin
/// and K at rest.
StructureParts at_spin(const StructureParts& parts, double spin);
/// (K − K at rest)/Ω², lower triangle.
SparseMatrix stiffness_per_spin2(const StructureParts& parts);

/// M, K and G = 2ΩM[a]×, a the unit axis: of mass that is the same in all directions and couples none, as that of
/// displacements of nodes is. @throws LawBroken, with the nodes named, where mass couples directions or differs between
/// them, or where the mass between two nodes is not in M because they share no direction; and as SparseSystem
SparseMatrices assembled(const StructureParts& parts);

/// What an inspection of a mesh tells.
struct MeshFacts {
  Index nodes = 0;
  std::array<double, 3> mass_per_direction{};  ///< the sum of M over the coordinates of each; without what is held
  /// Where positions are known: the centre of mass, each coordinate by the mass of its direction, and the inertia about
  /// it, uᵀMu of the turns u = e × (p − centre): xx, yy, zz, xy, yz, zx (the last three as ∫ −xy dm).
  std::optional<std::array<double, 3>> centre;
  std::optional<std::array<double, 6>> inertia;
};
MeshFacts facts_of(const StructureParts& parts);
/// The centre of it alone.
std::optional<std::array<double, 3>> centre_of(const StructureParts& parts);

}  // namespace gyromode
