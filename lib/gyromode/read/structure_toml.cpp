#include "gyromode/read/structure_toml.h"

#include "gyromode/base/error.h"
#include "gyromode/formats/dof_table.h"
#include "gyromode/formats/node_table.h"
#include "gyromode/formats/triplet_file.h"
#include "gyromode/read/sparse_files.h"

#include <fmt/format.h>

#include <array>
#include <future>
#include <unordered_map>

namespace gyromode::io {

namespace {

constexpr std::array<std::string_view, 16> keys{
    "stiffness_at_rest", "gyroscopic", "kind", "title", "reference",   "known",  "parameters", "frame", "mass",
    "stiffness",         "dofs",       "spin", "axis",  "coordinates", "mirror", "half_turn"};

std::filesystem::path place_of(const TomlTable& table, std::string_view key) {
  const auto name = table.text(key);
  if (!name)
    table.fail(fmt::format("key '{}' is missing: a file was expected, such as \"job.{}\"", key,
                           key == "mass"         ? "mas"
                           : key == "dofs"       ? "dof"
                           : key == "gyroscopic" ? "gyr"
                                                 : "sti"));
  return table.folder() / *name;
}

std::filesystem::path file_named(const TomlTable& table, std::string_view key, Digest& digest) {
  std::filesystem::path file = place_of(table, key);
  digest.add_large(file);
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
  // Side by side; the digest has them in this order.
  auto mass = std::async(std::launch::async, [file = file_named(table, "mass", digest), n] { return read_triplets(file, n, 1); });
  p.stiffness = read_triplets(file_named(table, "stiffness", digest), n, 1);
  p.mass = mass.get();
  if (table.text("coordinates")) {
    const std::filesystem::path file = file_named(table, "coordinates", digest);
    std::unordered_map<long, std::array<double, 3>> at;
    for (const MeshNode& m : read_nodes(file)) at.emplace(m.node, m.at);
    for (const MeshCoordinate& c : p.coordinates) {
      const auto node = at.find(c.node);
      if (node == at.end())
        throw Unreadable(file, fmt::format("has no node {}, which {} has coordinates of", c.node, dofs.filename().string()));
      p.positions.push_back(node->second);
    }
  }
  for (const auto& [key, kind] : {std::pair("mirror", MeshSymmetry::Kind::mirror), {"half_turn", MeshSymmetry::Kind::half_turn}}) {
    const std::vector<double> direction = table.numbers(key);
    if (direction.empty()) continue;
    if (direction.size() != 3)
      table.fail(key, fmt::format("'{}' has {} numbers: the three of a direction were expected", key, direction.size()));
    if (p.symmetry) table.fail(key, "'mirror' and 'half_turn' are given: one of them was expected");
    p.symmetry = MeshSymmetry{kind, {direction[0], direction[1], direction[2]}};
  }
  p.spin = table.frequency("spin").value_or(0);
  if (table.has("stiffness_at_rest")) {
    if (p.spin == 0)
      table.fail("stiffness_at_rest",
                 "'stiffness_at_rest' says what the spin adds to 'stiffness', and needs 'spin' = that of 'stiffness', not 0");
    const std::filesystem::path file = file_named(table, "stiffness_at_rest", digest);
    p.stiffness_at_rest = read_triplets(file, n, 1);
    const Vector diagonal = p.stiffness_at_rest.diagonal();
    for (Index k = 0; k < n; ++k) {  // a file that was cut off still has entries
      if (!(diagonal(k) > 0))
        throw Unreadable(file, fmt::format("entry ({0}, {0}) is {1}: of a structure at rest it is above 0; is the file whole, and that of "
                                           "the mesh at rest?",
                                           k + 1, diagonal(k)));
    }
  }
  const std::vector<double> axis = table.numbers("axis");
  if (!axis.empty() && axis.size() != 3)
    table.fail("axis", fmt::format("'axis' has {} numbers: the three of a direction were expected", axis.size()));
  if (axis.size() == 3) p.axis = {axis[0], axis[1], axis[2]};
  return p;
}

SparseMatrices read_sparse_matrices(const TomlTable& table, Digest& digest) {
  table.allow_only(keys);
  for (const std::string_view key : {"spin", "axis", "coordinates", "mirror", "half_turn", "stiffness_at_rest"}) {
    if (table.has(key))
      table.fail(key,
                 fmt::format("'{}' is for G that is made of M, and 'gyroscopic' gives G by its own file: one of them was expected", key));
  }
  Labels labels;
  std::vector<int> node;
  if (table.text("dofs")) {
    std::unordered_map<long, int> nodes;
    for (const MeshDof& d : read_dof_table(file_named(table, "dofs", digest))) {
      labels.push_back(fmt::format("{}.{}", d.node, d.direction));
      node.push_back(nodes.try_emplace(d.node, static_cast<int>(nodes.size())).first->second);
    }
  }
  SparseMatrices all = read_sparse_files({place_of(table, "mass"), place_of(table, "gyroscopic"), place_of(table, "stiffness")},
                                         static_cast<Index>(labels.size()), digest);
  all.labels = std::move(labels);
  all.node = std::move(node);
  return all;
}

}  // namespace gyromode::io
