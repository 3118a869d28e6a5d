#pragma once

#include "gyromode/models/structure_mesh.h"

#include <array>
#include <vector>

namespace gyromode::bench {

/// Nodes and 8-node bricks, corners in the order (0,0,0), (1,0,0), (1,1,0), (0,1,0), then the same above.
struct BrickMesh {
  std::vector<std::array<double, 3>> nodes;
  std::vector<std::array<int, 8>> bricks;
  std::vector<bool> held;  ///< of every node
};

/// An isotropic material.
struct Material {
  double young = 210e9, poisson = 0.3, density = 7850;
};

/// A box of a × b × c along x, y, z, in the middle of the axis z, nx × ny × nz bricks; clamped at z = 0 or free.
BrickMesh box(std::array<double, 3> size, std::array<int, 3> bricks, bool clamped);

/// A disc with blades: a ring of inner radius 1, clamped there, and outer radius 2, `blades` blades of length 1.5, each
/// turned about its own radius by `twist` from root to tip, and moved sideways by `lean`, which leaves no symmetry.
/// `fine` bricks across every thickness.
BrickMesh bladed_disc(int blades, int fine, double twist, double lean);

/// M (consistent) and K (2 × 2 × 2 points, with the softening −Ω²M across the axis) in axes that turn at `spin` about
/// z; with the stress that a displacement of all nodes, three numbers each, makes, where one is given.
StructureParts assembled_bricks(const BrickMesh& mesh, const Material& material, double spin, const Vector& displacement = {});

/// What the spin does to the mesh at rest in its axes. Without its stress a body that nothing holds has no free
/// turning.
Vector displacement_under_spin(const BrickMesh& mesh, const Material& material, double spin);

}  // namespace gyromode::bench
