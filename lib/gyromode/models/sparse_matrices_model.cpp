#include "gyromode/models/sparse_matrices_model.h"

#include "gyromode/base/error.h"
#include "gyromode/models/family_parameters.h"
#include "gyromode/modes/modes.h"
#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/partition.h"
#include "gyromode/sparse/stiffness.h"

#include <utility>

namespace gyromode {

namespace {

using NamedNumbers = std::vector<std::pair<std::string, double>>;

double largest_entry_of(const SparseMatrix& a) { return a.nonZeros() > 0 ? a.coeffs().cwiseAbs().maxCoeff() : 0; }

}  // namespace

ModesResult SparseMatricesModel::modes(const ModesOptions& options) const { return find_modes(system_, options); }

CountResult SparseMatricesModel::count(const Window& window) const { return count_modes(system_, window); }

StructureReport SparseMatricesModel::structure(std::optional<double> at) const {
  if (at) throw NotApplicable("--at writes H(ω) in full, which a large sparse model has no use for");
  StructureReport r;
  const Structure s = sparse::analyse(system_);
  r.structure = system_.basis() ? system_.basis()->given : s;
  const sparse::StiffnessFactors stiffness(system_, sparse::groups_of(s, system_.size()));
  r.stiffness = {stiffness.negative(), stiffness.nullity()};
  const auto named = [&](const auto& number) {
    return NamedNumbers{
        {"mass", number(system_.mass())}, {"gyroscopic", number(system_.gyroscopic())}, {"stiffness", number(system_.stiffness())}};
  };
  r.checks.push_back({"scales", named(largest_entry_of)});
  r.checks.push_back({"entries", named([](const SparseMatrix& a) { return static_cast<double>(a.nonZeros()); })});
  return r;
}

std::vector<std::string> SparseMatricesModel::doubts(bool) const {
  if (!system_.singular_mass()) return {};
  return {"M is singular to rounding, as elements of reduced integration leave it: motions without mass have no frequency of their own"};
}

std::shared_ptr<const ModelKind> model_of_sparse(SparseMatrices m) {
  constexpr Index few = 1000;
  if (m.mass.cols() > few || SparseSystem(m).singular_mass()) return std::make_shared<SparseMatricesModel>(std::move(m));
  SpinFamily family{sparse::full(m.mass, 1), sparse::full(m.gyroscopic, -1), {}, sparse::full(m.stiffness, 1), {}, std::move(m.labels), {}};
  return model_of({std::make_shared<const SpinFamily>(std::move(family)), std::nullopt});
}

}  // namespace gyromode
