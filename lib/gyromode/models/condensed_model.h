#pragma once

#include "gyromode/models/family_parameters.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/system/condensation.h"

namespace gyromode {

/// M, G, K where some coordinates have no mass: they follow the others (Condensation), shapes are given in all
/// coordinates, and error bounds hold what condensing them rounds.
class CondensedModel : public ModelKind {
 public:
  CondensedModel(FamilyAtSpin matrices, Condensation condensation);

  Index size() const override { return static_cast<Index>(c_.labels.size()); }
  const Labels& labels() const override { return c_.labels; }
  std::string_view in_words() const override { return "M, G, K"; }
  Labels massless() const override;
  ModesResult modes(const ModesOptions& options) const override;
  CountResult count(const Window& window) const override;
  StabilityReport stability(const Progress& progress) const override;
  StructureReport structure(std::optional<double> at) const override;
  CriticalSpeeds critical_speeds(const CriticalOptions& options) const override;
  TurningForce unbalance(const std::vector<Unbalance>& masses) const override;
  std::vector<OrbitCoordinates> orbits() const override { return matrices_.orbits; }
  SpinSource spin_source() const override;
  void require_motion() const override {}
  ResponseReport response(const MotionRequest& request) const override;
  std::vector<Parameter> parameters() const override { return matrices_.parameters(); }
  std::vector<Parameter> named_parameters() const override;
  std::optional<Parameter> parameter(std::string_view key) const override { return matrices_.parameter(key); }
  std::shared_ptr<const ModelKind> with(const std::vector<ParameterValue>& values) const override;
  /// Of the condensed system, in the coordinates that have mass.
  const System* second_order() const override { return &c_.reduced; }
  std::vector<NamedMatrix> matrices() const override;

 private:
  void expand(std::vector<Mode>& modes) const;
  ModesResult expanded(ModesResult result, bool with_shapes) const;
  void to_all(Structure& s) const;

  FamilyAtSpin matrices_;
  Condensation c_;
};

}  // namespace gyromode
