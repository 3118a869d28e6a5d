#include "gyromode/models/structure_model.h"

#include "gyromode/base/error.h"
#include "gyromode/models/family_parameters.h"
#include "gyromode/models/mesh_symmetry.h"
#include "gyromode/modes/modes.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/partition.h"
#include "gyromode/sparse/stiffness.h"
#include "gyromode/sweep/large_family.h"

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

bool says_how_it_depends_on_the_spin(const StructureParts& p) { return p.stiffness_at_rest.cols() > 0 && p.spin != 0; }

std::vector<Parameter> spin_of(double spin) { return {{"spin", Dimension::frequency, spin}}; }

// The value that the spin takes.
double spin_among(const std::vector<ParameterValue>& values) {
  if (values.empty()) throw InvalidArgument("a value of the spin was expected");
  for (const ParameterValue& v : values) {
    if (v.key != "spin") throw InvalidArgument(fmt::format("'{}' is no parameter of a structure: spin is", v.key));
  }
  return values.back().value;
}

std::shared_ptr<const ModelKind> dense_model_of(const StructureParts& p) {
  SparseMatrices m = assembled(p);
  Matrix mass = sparse::full(m.mass, 1), g = sparse::full(m.gyroscopic, -1);
  SpinFamily family{std::move(mass), g, {}, sparse::full(m.stiffness, 1), {}, std::move(m.labels), {}};
  std::optional<double> spin;
  if (says_how_it_depends_on_the_spin(p)) {
    spin = p.spin;
    family.gyroscopic_per_spin = g / p.spin;
    family.gyroscopic.setZero();
    family.stiffness = sparse::full(p.stiffness_at_rest, 1);
    family.stiffness_per_spin2 = sparse::full(stiffness_per_spin2(p), 1);
  }
  return model_of({std::make_shared<const SpinFamily>(std::move(family)), spin, orbits_across_z(p)});
}

// AX of a symmetric or skew A by its lower triangle.
ComplexMatrix times(const SparseMatrix& a, bool skew, const ComplexMatrix& x) {
  const auto product = [&](const Matrix& part) { return skew ? sparse::skew_times(a, part) : sparse::symmetric_times(a, part); };
  return product(x.real()).cast<Complex>() + Complex(0, 1) * product(x.imag()).cast<Complex>();
}

void require_at_rest(bool known) {
  if (!known)
    throw NotApplicable(
        "K of a structure holds the stress and the softening of its own spin: give K of the same mesh at rest, too, by the key "
        "'stiffness_at_rest', for what goes with the spin");
}

Campbell campbell_of(const StructureParts& p, const CampbellOptions& options) {
  LargeFamily f;
  f.mass = p.mass;
  f.gyroscopic_per_spin = assembled(p).gyroscopic / p.spin;
  f.stiffness = p.stiffness_at_rest;
  f.stiffness_per_spin2 = stiffness_per_spin2(p);
  f.places = orbits_across_z(p);
  f.modes = [&p](double spin, const ModesOptions& o) { return SparseMatricesModel(in_symmetric_coordinates(at_spin(p, spin))).modes(o); };
  return gyromode::campbell(f, options);
}

}  // namespace

StructureModel::StructureModel(StructureParts parts)
    : SparseMatricesModel(in_symmetric_coordinates(parts)), facts_(facts_of(parts)), spin_(parts.spin) {
  if (says_how_it_depends_on_the_spin(parts)) parts_ = std::make_shared<const StructureParts>(std::move(parts));
}

Campbell StructureModel::campbell(const CampbellOptions& options) const {
  require_at_rest(parts_ != nullptr);
  return campbell_of(*parts_, options);
}

CriticalSpeeds StructureModel::critical_speeds(const CriticalOptions&) const {
  throw NotApplicable(
      "critical speeds by one pencil are for dense matrices: of a large structure campbell --order 1,2,… intersects the branches with the "
      "lines of the orders, in the turning axes of the structure");
}

// H = K₀ + Ω²K₂ + jωΩG₁ − ω²M.
std::optional<ModelKind::SpinSlopes> StructureModel::spin_slopes(double omega, const ComplexMatrix& x) const {
  if (!parts_) return std::nullopt;
  if (!with_spin_) with_spin_ = std::make_shared<const WithSpin>(WithSpin{assembled(*parts_).gyroscopic, stiffness_per_spin2(*parts_)});
  const ComplexMatrix gx = times(with_spin_->gyroscopic, true, x);
  return SpinSlopes{2 * spin_ * times(with_spin_->per_spin2, false, x) + Complex(0, omega / spin_) * gx,
                    2 * omega * times(parts_->mass, false, x) - Complex(0, 1) * gx};
}

std::optional<Parameter> StructureModel::parameter(std::string_view key) const {
  if (key == "spin") require_at_rest(parts_ != nullptr);
  return ModelKind::parameter(key);
}

std::vector<Parameter> StructureModel::parameters() const { return parts_ ? spin_of(spin_) : std::vector<Parameter>{}; }

std::shared_ptr<const ModelKind> StructureModel::with(const std::vector<ParameterValue>& values) const {
  if (!parts_) return ModelKind::with(values);
  return std::make_shared<StructureModel>(at_spin(*parts_, spin_among(values)));
}

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

std::vector<std::string> SmallStructureModel::doubts(bool fixed_axes) const {
  std::vector<std::string> all = DelegatingModel::doubts(fixed_axes);
  if (!all.empty() && says_how_it_depends_on_the_spin(parts_))
    all = {
        fmt::format("what 'stiffness' has more than 'stiffness_at_rest' is not the softening of spin = {:.6g} rad/s: was 'stiffness' made "
                    "at that spin?",
                    parts_.spin)};
  return all;
}

// Beyond a few hundred coordinates a projection takes a tenth of the time of dense matrices at every spin looked at.
Campbell SmallStructureModel::campbell(const CampbellOptions& options) const {
  constexpr Index few = 300;
  require_at_rest(says_how_it_depends_on_the_spin(parts_));
  return size() > few ? campbell_of(parts_, options) : DelegatingModel::campbell(options);
}

CriticalSpeeds SmallStructureModel::critical_speeds(const CriticalOptions& options) const {
  require_at_rest(says_how_it_depends_on_the_spin(parts_));
  return DelegatingModel::critical_speeds(options);
}

std::optional<Parameter> SmallStructureModel::parameter(std::string_view key) const {
  if (key == "spin") require_at_rest(says_how_it_depends_on_the_spin(parts_));
  return ModelKind::parameter(key);
}

std::vector<Parameter> SmallStructureModel::parameters() const {
  return says_how_it_depends_on_the_spin(parts_) ? spin_of(parts_.spin) : std::vector<Parameter>{};
}

std::shared_ptr<const ModelKind> SmallStructureModel::with(const std::vector<ParameterValue>& values) const {
  if (!says_how_it_depends_on_the_spin(parts_)) return ModelKind::with(values);
  return std::make_shared<SmallStructureModel>(at_spin(parts_, spin_among(values)));
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
