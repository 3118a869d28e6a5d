#include "gyromode/read/structure_toml.h"

#include "gyromode/base/error.h"
#include "gyromode/formats/dof_table.h"
#include "gyromode/formats/triplet_file.h"

#include <fmt/format.h>

#include <array>

namespace gyromode::io {

namespace {

constexpr std::array<std::string_view, 11> keys{"kind", "title",     "reference", "known", "parameters", "frame",
                                                "mass", "stiffness", "dofs",      "spin",  "axis"};

std::filesystem::path file_named(const TomlTable& table, std::string_view key, Digest& digest) {
  const auto name = table.text(key);
  if (!name)
    table.fail(fmt::format("key '{}' is missing: a file was expected, such as \"job.{}\"", key,
                           key == "mass"   ? "mas"
                           : key == "dofs" ? "dof"
                                           : "sti"));
  const std::filesystem::path file = table.folder() / *name;
  digest.add(file, fmt::format("{} of {} bytes", *name, std::filesystem::exists(file) ? std::filesystem::file_size(file) : 0));
  return file;
}

}  // namespace

StructureParts read_structure(const TomlTable& table, Digest& digest) {
  table.allow_only(keys);
  StructureParts p;
  const std::filesystem::path dofs = file_named(table, "dofs", digest);
  for (const MeshDof& d : read_dof_table(dofs)) {
    if (d.direction > 3)
      throw LawBroken(fmt::format("{}: node {} has rotations (direction {}): Coriolis forces are made of displacements only", dofs.string(),
                                  d.node, d.direction));
    p.coordinates.push_back({d.node, d.direction - 1});
  }
  const auto n = static_cast<Index>(p.coordinates.size());
  p.mass = read_symmetric_triplets(file_named(table, "mass", digest), n);
  p.stiffness = read_symmetric_triplets(file_named(table, "stiffness", digest), n);
  p.spin = table.frequency("spin").value_or(0);
  const std::vector<double> axis = table.numbers("axis");
  if (!axis.empty() && axis.size() != 3)
    table.fail("axis", fmt::format("'axis' has {} numbers: the three of a direction were expected", axis.size()));
  if (axis.size() == 3) p.axis = {axis[0], axis[1], axis[2]};
  return p;
}

}  // namespace gyromode::io
