#pragma once

#include "gyromode/models/structure_mesh.h"
#include "gyromode/sparse/folding.h"

#include <optional>
#include <string>

namespace gyromode {

/// A symmetry that a mesh was shown to have, entry by entry.
struct FoundSymmetry {
  MeshSymmetry symmetry;
  sparse::Involution of_coordinates;
  double departure = 0;  ///< the largest of an entry of M, K or G, relative; averaged away
};

/// The one asked for, or else the first of the mirror planes and half-turns along coordinate axes across the axis of
/// the spin; planes and axes go through the middle of the mesh. Nothing where positions are not known or none fits.
/// `matrices` are those of the mesh. @throws LawBroken where the one asked for does not fit: with the node that has no
/// image, or the entry that differs; and where it is not across the axis
std::optional<FoundSymmetry> symmetry_of(const StructureParts& parts, const SparseMatrices& matrices);

/// The matrices of the mesh; where the coordinates show no partition and a symmetry that reverses the spin is there,
/// in coordinates that have one, by its even and odd motions. @throws as symmetry_of
SparseMatrices in_symmetric_coordinates(const StructureParts& parts);

/// "mirror plane across y, through the axis".
std::string in_words(const MeshSymmetry& symmetry);

/// The same mesh in axes in which the symmetry asked for is along x, where it is along none of x, y, z: `turn` has the
/// new axes as columns. @throws LawBroken where a node does not keep all directions that are mixed
StructureParts turned(const StructureParts& parts, const std::array<std::array<double, 3>, 3>& turn);

}  // namespace gyromode
