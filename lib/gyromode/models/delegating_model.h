#pragma once

#include "gyromode/models/model_kind.h"

namespace gyromode {

/// A kind of model that answers by another one, which it made; parameters are its own.
class DelegatingModel : public ModelKind {
 public:
  explicit DelegatingModel(std::shared_ptr<const ModelKind> made) : made_(std::move(made)) {}

  Index size() const override { return made_->size(); }
  const Labels& labels() const override { return made_->labels(); }
  std::string_view in_words() const override { return made_->in_words(); }
  Labels massless() const override { return made_->massless(); }
  bool transcendental() const override { return made_->transcendental(); }
  bool finite() const override { return made_->finite(); }
  bool has_outlines() const override { return made_->has_outlines(); }
  ModesResult modes(const ModesOptions& options) const override { return made_->modes(options); }
  CountResult count(const Window& window) const override { return made_->count(window); }
  std::vector<PlannedFactorisation> plan() const override { return made_->plan(); }
  ModesResult verdict(bool with_shapes, const Progress& progress) const override { return made_->verdict(with_shapes, progress); }
  StabilityReport stability(const Progress& progress) const override { return made_->stability(progress); }
  StructureReport structure(std::optional<double> at) const override { return made_->structure(at); }
  CriticalSpeeds critical_speeds(const CriticalOptions& options) const override { return made_->critical_speeds(options); }
  TurningForce unbalance(const std::vector<Unbalance>& masses) const override { return made_->unbalance(masses); }
  std::vector<OrbitCoordinates> orbits() const override { return made_->orbits(); }
  std::vector<EnergyShare> energy_shares(const Mode& mode, const std::vector<ModelOutline>& outlines) const override {
    return made_->energy_shares(mode, outlines);
  }
  std::string name_of(const Mode& mode, const std::vector<EnergyShare>& shares) const override { return made_->name_of(mode, shares); }
  SpinSource spin_source() const override { return made_->spin_source(); }
  std::vector<double> divergence_thresholds(std::string_view key, double a, double b) const override {
    return made_->divergence_thresholds(key, a, b);
  }
  void require_motion() const override { made_->require_motion(); }
  ResponseReport response(const MotionRequest& request) const override { return made_->response(request); }
  FrequencyReport frequency_response(const FrequencyRequest& request) const override { return made_->frequency_response(request); }
  std::vector<std::string> doubts(bool fixed_axes) const override { return made_->doubts(fixed_axes); }
  const System* second_order() const override { return made_->second_order(); }
  std::vector<NamedMatrix> matrices() const override { return made_->matrices(); }
  std::optional<IgnoredCouplings> left_out() const override { return made_->left_out(); }
  std::shared_ptr<const ModelKind> discretised(std::optional<Index> elements) const override { return made_->discretised(elements); }

 protected:
  const std::shared_ptr<const ModelKind>& made() const { return made_; }
  void answer_by(std::shared_ptr<const ModelKind> made) { made_ = std::move(made); }

 private:
  std::shared_ptr<const ModelKind> made_;
};

}  // namespace gyromode
