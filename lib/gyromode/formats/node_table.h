#pragma once

#include <array>
#include <filesystem>
#include <vector>

namespace gyromode::io {

/// A node of a mesh and where it is.
struct MeshNode {
  long node = 0;
  std::array<double, 3> at{};
};

/// The *NODE blocks of an Abaqus or CalculiX deck (`number, x, y, z`; what is left out is 0), or a table with a line
/// `node,x,y,z` each. @throws Unreadable with file, line, and what was expected
std::vector<MeshNode> read_nodes(const std::filesystem::path& file);

}  // namespace gyromode::io
