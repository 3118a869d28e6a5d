#pragma once

#include "gyromode/models/delegating_model.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/models/structure_mesh.h"

namespace gyromode {

/// A finite-element export in axes that turn with the structure, sparse.
class StructureModel : public ModelKind {
 public:
  /// @throws LawBroken; TooLarge
  explicit StructureModel(StructureParts parts);

  const SparseSystem& system() const { return system_; }
  Index size() const override { return system_.size(); }
  const Labels& labels() const override { return system_.labels(); }
  std::string_view in_words() const override { return "sparse M, G, K"; }
  bool finite() const override { return false; }
  ModesResult modes(const ModesOptions& options) const override;
  CountResult count(const Window& window) const override;
  StructureReport structure(std::optional<double> at) const override;
  std::vector<std::string> doubts(bool fixed_axes) const override;

 private:
  StructureParts parts_;
  SparseSystem system_;
};

/// The same of few coordinates, answered by the dense engine: all verbs that matrices at one spin have.
class SmallStructureModel : public DelegatingModel {
 public:
  explicit SmallStructureModel(StructureParts parts);
  ModesResult modes(const ModesOptions& options) const override;
  StructureReport structure(std::optional<double> at) const override;

 private:
  StructureParts parts_;
  std::string symmetry_;  // in words; empty where none is needed or known
  double departure_ = 0;
};

/// The model of a mesh: dense up to 1000 coordinates where M is positive definite and the body is held in all
/// directions, else sparse. @throws LawBroken;
/// TooLarge
std::shared_ptr<const ModelKind> model_of_structure(StructureParts parts);

}  // namespace gyromode
