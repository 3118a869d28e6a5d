#pragma once

#include <filesystem>
#include <vector>

namespace gyromode::io {

/// A coordinate of a mesh: the number of its node, and 1, 2, 3 for a displacement along x, y, z; 4, 5, 6 rotations.
struct MeshDof {
  long node = 0;
  int direction = 0;
};

/// A line `node.direction` a coordinate, as CalculiX writes it beside stored matrices (.dof). @throws Unreadable with
/// file, line, and what was expected
std::vector<MeshDof> read_dof_table(const std::filesystem::path& file);

}  // namespace gyromode::io
