#pragma once

#include "gyromode/models/model.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

namespace gyromode {

/// M q̈ + G q̇ + K q = 0.
class MatricesModel : public ModelKind {
 public:
  explicit MatricesModel(System system) : system_(std::move(system)) {}

  const System& system() const { return system_; }
  Index size() const override { return system_.size(); }
  const Labels& labels() const override { return system_.labels(); }
  std::string_view in_words() const override { return "M, G, K in turning axes"; }
  ModesResult modes(const ModesRequest& request) const override;
  CountResult count(const Window& window) const override;
  StabilityReport stability() const override;
  StructureReport structure(std::optional<double> at) const override;
  void require_motion() const override {}
  ResponseReport response(const State& initial, const std::vector<Force>& forces, const std::vector<BoomPoint>& points, const Vector& times) const override;
  FrequencyReport frequency_response(const Vector& amplitude, const Vector& grid) const override;
  const System* second_order() const override { return &system_; }
  std::vector<NamedMatrix> matrices() const override;
  std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> without_couplings(double tolerance) const override;

 private:
  System system_;
};

/// I q̇ + G q = 0.
class FirstOrderModel : public ModelKind {
 public:
  explicit FirstOrderModel(FirstOrderSystem system) : system_(std::move(system)) {}

  const FirstOrderSystem& system() const { return system_; }
  Index size() const override { return system_.size(); }
  const Labels& labels() const override { return system_.labels(); }
  std::string_view in_words() const override { return "first order"; }
  ModesResult modes(const ModesRequest& request) const override;
  CountResult count(const Window& window) const override;
  StructureReport structure(std::optional<double> at) const override;
  std::vector<NamedMatrix> matrices() const override;
  std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> without_couplings(double tolerance) const override;

 private:
  FirstOrderSystem system_;
};

}  // namespace gyromode
