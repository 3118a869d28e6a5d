#include "gyromode/models/structure_model.h"

#include "gyromode/base/error.h"
#include "gyromode/models/family_parameters.h"
#include "gyromode/models/mesh_symmetry.h"
#include "gyromode/modes/modes.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/partition.h"
#include "gyromode/sparse/stiffness.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <utility>

namespace gyromode {

namespace {

using NamedNumbers = std::vector<std::pair<std::string, double>>;

// What an inspection tells of the mesh.
std::vector<ModelCheck> checks_of(const MeshFacts& f) {
  const auto& mass = f.mass_per_direction;
  std::vector<ModelCheck> all{{"nodes", static_cast<double>(f.nodes)},
                              {"mass_per_direction", NamedNumbers{{"x", mass[0]}, {"y", mass[1]}, {"z", mass[2]}}}};
  if (f.centre) all.push_back({"centre", NamedNumbers{{"x", (*f.centre)[0]}, {"y", (*f.centre)[1]}, {"z", (*f.centre)[2]}}});
  if (f.inertia) {
    const auto& i = *f.inertia;
    all.push_back({"inertia", NamedNumbers{{"xx", i[0]}, {"yy", i[1]}, {"zz", i[2]}, {"xy", i[3]}, {"yz", i[4]}, {"zx", i[5]}}});
  }
  return all;
}

// Displacements across z, where the axes turn about it.
std::vector<OrbitCoordinates> orbits_across_z(const StructureParts& p) {
  std::vector<OrbitCoordinates> all;
  if (p.axis[0] != 0 || p.axis[1] != 0) return all;
  std::map<long, std::array<Index, 2>> nodes;
  for (std::size_t k = 0; k < p.coordinates.size(); ++k) {
    const MeshCoordinate& c = p.coordinates[k];
    if (c.direction > 1) continue;
    auto& pair = nodes.try_emplace(c.node, std::array<Index, 2>{-1, -1}).first->second;
    pair[static_cast<std::size_t>(c.direction)] = static_cast<Index>(k);
  }
  for (const auto& [node, at] : nodes) {
    if (at[0] >= 0 && at[1] >= 0) all.push_back({at[0], at[1], fmt::format("node {}", node)});
  }
  return all;
}

std::shared_ptr<const ModelKind> dense_model_of(const StructureParts& p) {
  SparseMatrices m = assembled(p);
  SpinFamily family{sparse::full(m.mass, 1), sparse::full(m.gyroscopic, -1), {}, sparse::full(m.stiffness, 1), {}, std::move(m.labels), {}};
  return model_of({std::make_shared<const SpinFamily>(std::move(family)), std::nullopt, orbits_across_z(p)});
}

}  // namespace

StructureModel::StructureModel(StructureParts parts)
    : SparseMatricesModel(in_symmetric_coordinates(parts)), facts_(facts_of(parts)), spin_(parts.spin) {}

StructureReport StructureModel::structure(std::optional<double> at) const {
  StructureReport r = SparseMatricesModel::structure(at);
  std::vector<ModelCheck> checks = checks_of(facts_);
  if (const sparse::Basis* b = system().basis()) {
    checks.push_back({"symmetry", b->in_words});
    checks.push_back({"symmetry_departure", b->departure});
  }
  r.checks.insert(r.checks.begin(), std::make_move_iterator(checks.begin()), std::make_move_iterator(checks.end()));
  return r;
}

std::vector<std::string> StructureModel::doubts(bool fixed_axes) const {
  std::vector<std::string> all = SparseMatricesModel::doubts(fixed_axes);
  if (system().translations().cols() > 0)
    all.push_back(
        fmt::format("nothing holds the body across its axis: its translation, a double root at the spin {:.6g} rad/s, is no vibration and "
                    "is left out",
                    std::abs(spin_)));
  return all;
}

SmallStructureModel::SmallStructureModel(StructureParts parts) : DelegatingModel(dense_model_of(parts)), parts_(std::move(parts)) {
  const SparseMatrices m = in_symmetric_coordinates(parts_);
  if (!m.basis) return;
  symmetry_ = m.basis->in_words;
  departure_ = m.basis->departure;
}

ModesResult SmallStructureModel::modes(const ModesOptions& options) const {
  ModesResult r = DelegatingModel::modes(options);
  for (Component& c : r.structure.components) c.mesh_symmetry = !symmetry_.empty() && !c.quadrature();
  return r;
}

StructureReport SmallStructureModel::structure(std::optional<double> at) const {
  StructureReport r = DelegatingModel::structure(at);
  for (ModelCheck& c : checks_of(facts_of(parts_))) r.checks.push_back(std::move(c));
  if (symmetry_.empty()) return r;
  for (Component& c : r.structure.components) c.mesh_symmetry = !c.quadrature();
  r.checks.push_back({"symmetry", symmetry_});
  r.checks.push_back({"symmetry_departure", departure_});
  return r;
}

std::shared_ptr<const ModelKind> model_of_structure(StructureParts parts) {
  constexpr Index few = 1000;
  const auto needs_sparse = [&] {
    const SparseSystem s(assembled(parts));
    return s.singular_mass() || s.translations().cols() > 0 || s.rigid().cols() > 0;
  };
  if (parts.mass.cols() > few || needs_sparse()) return std::make_shared<StructureModel>(std::move(parts));
  return std::make_shared<SmallStructureModel>(std::move(parts));
}

}  // namespace gyromode
