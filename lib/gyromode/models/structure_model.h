#pragma once

#include "gyromode/models/delegating_model.h"
#include "gyromode/models/sparse_matrices_model.h"
#include "gyromode/models/structure_mesh.h"

namespace gyromode {

/// A finite-element export in axes that turn with the structure, sparse.
class StructureModel : public SparseMatricesModel {
 public:
  /// @throws LawBroken; TooLarge
  explicit StructureModel(StructureParts parts);

  StructureReport structure(std::optional<double> at) const override;
  std::vector<std::string> doubts(bool fixed_axes) const override;
  /// Where K at rest is known; else NotApplicable. At every spin by modes() there, between them by a projection.
  Campbell campbell(const CampbellOptions& options) const override;
  std::optional<SpinSlopes> spin_slopes(double omega, const ComplexMatrix& shapes) const override;
  /// @throws NotApplicable, with what tells them
  CriticalSpeeds critical_speeds(const CriticalOptions& options) const override;

  /// The spin, where K at rest is known.
  std::vector<Parameter> parameters() const override;
  /// @throws NotApplicable for the spin where K at rest is not known
  std::optional<Parameter> parameter(std::string_view key) const override;
  std::shared_ptr<const ModelKind> with(const std::vector<ParameterValue>& values) const override;

 private:
  MeshFacts facts_;
  double spin_ = 0;
  std::shared_ptr<const StructureParts> parts_;  // where K at rest is known
  struct WithSpin {
    SparseMatrix gyroscopic, per_spin2;  // G and K₂
  };
  mutable std::shared_ptr<const WithSpin> with_spin_;  // made when first asked for
};

/// The same of few coordinates, answered by the dense engine: all verbs that matrices at one spin have.
class SmallStructureModel : public DelegatingModel {
 public:
  explicit SmallStructureModel(StructureParts parts);
  ModesResult modes(const ModesOptions& options) const override;
  StructureReport structure(std::optional<double> at) const override;
  std::vector<std::string> doubts(bool fixed_axes) const override;
  CriticalSpeeds critical_speeds(const CriticalOptions& options) const override;
  Campbell campbell(const CampbellOptions& options) const override;
  /// The spin, where K at rest is known.
  std::vector<Parameter> parameters() const override;
  /// @throws NotApplicable for the spin where K at rest is not known
  std::optional<Parameter> parameter(std::string_view key) const override;
  std::shared_ptr<const ModelKind> with(const std::vector<ParameterValue>& values) const override;

 private:
  StructureParts parts_;
  std::string symmetry_;  // in words; empty where none is needed or known
  double departure_ = 0;
};

/// The model of a mesh: dense up to 1000 coordinates where M is positive definite and the body is held in all
/// directions, else sparse. @throws LawBroken; TooLarge
std::shared_ptr<const ModelKind> model_of_structure(StructureParts parts);

}  // namespace gyromode
