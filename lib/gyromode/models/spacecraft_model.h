#pragma once

#include "gyromode/models/model_kind.h"
#include "gyromode/spacecraft/spacecraft.h"

namespace gyromode {

/// A rigid body with wire booms, axial booms and masses on springs, by exact fields.
class SpacecraftModel : public ModelKind {
 public:
  explicit SpacecraftModel(Spacecraft spacecraft) : spacecraft_(std::move(spacecraft)) {}

  const Spacecraft& spacecraft() const { return spacecraft_; }
  Index size() const override { return spacecraft_.size(); }
  const Labels& labels() const override { return spacecraft_.labels(); }
  std::string_view in_words() const override { return "of the body, exact booms"; }
  bool transcendental() const override { return true; }
  bool has_outlines() const override { return true; }
  bool finite() const override { return spacecraft_.cables().empty() && spacecraft_.beams().empty(); }
  ModesResult modes(const ModesOptions& options) const override;
  CountResult count(const Window& window) const override;
  StructureReport structure(std::optional<double> at) const override;
  std::vector<OrbitCoordinates> orbits() const override { return {{3, 4}}; }
  std::vector<EnergyShare> energy_shares(const Mode& mode, const std::vector<ModelOutline>& outlines) const override;
  /// Nutation: the body tilts, holds most of the kinetic energy, and goes round forward in fixed axes. Rigid motions by
  /// what they are.
  std::string name_of(const Mode& mode, const std::vector<EnergyShare>& shares) const override;
  SpinSource spin_source() const override;
  void require_motion() const override {}
  ResponseReport response(const MotionRequest& request) const override;
  std::vector<Parameter> parameters() const override;
  std::shared_ptr<const ModelKind> with(const std::vector<ParameterValue>& values) const override;
  std::shared_ptr<const ModelKind> discretised(std::optional<Index> elements) const override;

 private:
  Spacecraft spacecraft_;
};

}  // namespace gyromode
