#pragma once

#include "gyromode/models/delegating_model.h"
#include "gyromode/rotor/rotor.h"

namespace gyromode {

/// Shafts with discs and bearings in fixed axes, by finite elements. Its parameters are the numbers of its parts, and
/// the speed.
class RotorModel : public DelegatingModel {
 public:
  /// @throws LawBroken
  explicit RotorModel(const Rotor& rotor);

  const Rotor& rotor() const { return rotor_; }
  std::string_view in_words() const override { return "rotor"; }
  bool has_outlines() const override { return true; }
  /// Stations so near to each other that the element between them costs digits.
  std::vector<std::string> doubts(bool fixed_axes) const override;
  /// With lines for pictures, where shapes are asked for.
  ModesResult modes(const ModesOptions& options) const override;
  CriticalSpeeds critical_speeds(const CriticalOptions& options) const override;
  TurningForce unbalance(const std::vector<Unbalance>& masses) const override;
  std::vector<OrbitCoordinates> orbits() const override;
  std::vector<EnergyShare> energy_shares(const Mode& mode, const std::vector<ModelOutline>& outlines) const override;
  SpinSource spin_source() const override;
  std::string speed_key() const override { return "speed"; }
  std::vector<Parameter> parameters() const override;
  std::shared_ptr<const ModelKind> with(const std::vector<ParameterValue>& values) const override;
  std::vector<Matrix> matrices_with(const std::vector<ParameterValue>& values) const override;
  std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> without_couplings(double tolerance) const override;

 private:
  RotorModel(const Rotor& rotor, std::shared_ptr<const SpinFamily> family);
  std::vector<OrbitCoordinates> transverse() const;

  Rotor rotor_;
  std::shared_ptr<const SpinFamily> family_;
};

}  // namespace gyromode
