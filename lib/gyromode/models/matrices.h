#pragma once

#include "gyromode/models/family_parameters.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/models/matrix_parameters.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/spin_family.h"
#include "gyromode/system/system.h"

namespace gyromode {

/// Of a model without its weak couplings: the whole one, which its parameters are those of.
template <class Kind>
struct CouplingsLeftOut {
  std::shared_ptr<const Kind> whole;
  double tolerance = 0;
};

/// M q̈ + G q̇ + K q = 0; or, of a SpinFamily, the system at one spin of it. Its parameters are the entries of the
/// matrices, and the spin.
class MatricesModel : public ModelKind {
 public:
  explicit MatricesModel(System system) : system_(std::move(system)) {}
  /// @throws LawBroken
  explicit MatricesModel(FamilyAtSpin matrices);

  const System& system() const { return system_; }
  Index size() const override { return system_.size(); }
  const Labels& labels() const override { return system_.labels(); }
  std::string_view in_words() const override { return "M, G, K"; }
  ModesResult modes(const ModesOptions& options) const override;
  CountResult count(const Window& window) const override;
  StabilityReport stability(const Progress& progress) const override;
  StructureReport structure(std::optional<double> at) const override;
  CriticalSpeeds critical_speeds(const CriticalOptions& options) const override;
  TurningForce unbalance(const std::vector<Unbalance>& masses) const override;
  std::vector<OrbitCoordinates> orbits() const override { return matrices_.orbits; }
  SpinSource spin_source() const override;
  std::vector<double> divergence_thresholds(std::string_view key, double a, double b) const override;
  void require_motion() const override {}
  ResponseReport response(const MotionRequest& request) const override;
  FrequencyReport frequency_response(const FrequencyRequest& request) const override;
  std::vector<std::string> doubts(bool fixed_axes) const override;
  std::vector<Parameter> parameters() const override;
  std::vector<Parameter> named_parameters() const override;
  std::optional<Parameter> parameter(std::string_view key) const override;
  std::shared_ptr<const ModelKind> with(const std::vector<ParameterValue>& values) const override;
  const System* second_order() const override { return &system_; }
  std::vector<NamedMatrix> matrices() const override;
  std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> without_couplings(double tolerance) const override;
  std::optional<IgnoredCouplings> left_out() const override;

 private:
  FamilyAtSpin matrices_at_spin() const;

  System system_;
  FamilyAtSpin matrices_;  // without a family where a System was given
  CouplingsLeftOut<MatricesModel> left_out_;
};

/// I q̇ + G q = 0.
class FirstOrderModel : public ModelKind {
 public:
  explicit FirstOrderModel(FirstOrderSystem system) : system_(std::move(system)) {}

  const FirstOrderSystem& system() const { return system_; }
  Index size() const override { return system_.size(); }
  const Labels& labels() const override { return system_.labels(); }
  std::string_view in_words() const override { return "first order"; }
  ModesResult modes(const ModesOptions& options) const override;
  CountResult count(const Window& window) const override;
  StructureReport structure(std::optional<double> at) const override;
  std::vector<Parameter> parameters() const override;
  std::vector<Parameter> named_parameters() const override;
  std::optional<Parameter> parameter(std::string_view key) const override;
  std::shared_ptr<const ModelKind> with(const std::vector<ParameterValue>& values) const override;
  std::vector<NamedMatrix> matrices() const override;
  std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> without_couplings(double tolerance) const override;
  std::optional<IgnoredCouplings> left_out() const override;

 private:
  FirstOrderSystem system_;
  CouplingsLeftOut<FirstOrderModel> left_out_;
};

}  // namespace gyromode
