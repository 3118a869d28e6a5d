#include "gyromode/models/structure_model.h"

#include "gyromode/base/error.h"
#include "gyromode/modes/modes.h"
#include "gyromode/sparse/partition.h"
#include "gyromode/sparse/shifted.h"

namespace gyromode {

namespace {

using NamedNumbers = std::vector<std::pair<std::string, double>>;

double largest_entry_of(const SparseMatrix& a) { return a.nonZeros() > 0 ? a.coeffs().cwiseAbs().maxCoeff() : 0; }

}  // namespace

StructureModel::StructureModel(StructureParts parts) : parts_(std::move(parts)), system_(assembled(parts_)) {}

ModesResult StructureModel::modes(const ModesOptions& options) const { return find_modes(system_, options); }

CountResult StructureModel::count(const Window& window) const { return count_modes(system_, window); }

StructureReport StructureModel::structure(std::optional<double> at) const {
  if (at) throw NotApplicable("--at writes H(ω) in full, which a large sparse model has no use for");
  StructureReport r;
  r.structure = sparse::analyse(system_);
  sparse::ShiftedImpedance h(system_, r.structure);
  r.stiffness.negative = h.negative_of_stiffness();
  const MeshFacts f = facts_of(parts_);
  r.checks = {
      {"nodes", static_cast<double>(f.nodes)},
      {"mass_per_direction", NamedNumbers{{"x", f.mass_per_direction[0]}, {"y", f.mass_per_direction[1]}, {"z", f.mass_per_direction[2]}}},
      {"scales",
       NamedNumbers{
           {"mass", largest_entry_of(system_.mass())}, {"gyroscopic", largest_entry_of(system_.gyroscopic())}, {"stiffness", largest_entry_of(system_.stiffness())}}},
      {"entries", NamedNumbers{{"mass", static_cast<double>(system_.mass().nonZeros())},
                          {"gyroscopic", static_cast<double>(system_.gyroscopic().nonZeros())},
                          {"stiffness", static_cast<double>(system_.stiffness().nonZeros())}}}};
  return r;
}

std::vector<std::string> StructureModel::doubts(bool) const {
  if (!system_.singular_mass()) return {};
  return {"M is singular to rounding, as elements of reduced integration leave it: motions without mass have no frequency of their own"};
}

}  // namespace gyromode
