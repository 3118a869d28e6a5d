#pragma once

#include "gyromode/models/parameters.h"
#include "gyromode/sweep/spin_sample.h"
#include "gyromode/system/spin_family.h"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace gyromode {

class ModelKind;

/// M, G₀, G₁, K₀, K₂ and the spin where they depend on one: what models of matrices of second order are made of, and
/// their parameters.
struct FamilyAtSpin {
  std::shared_ptr<const SpinFamily> family;
  std::optional<double> spin;                 ///< nothing: G₁ and K₂ are empty
  std::vector<OrbitCoordinates> orbits = {};  ///< displacements across the axis of one place each, as their maker says

  std::vector<Parameter> parameters() const;
  /// The spin, where there is one.
  std::vector<Parameter> named() const;
  std::optional<Parameter> parameter(std::string_view key) const;
  /// @throws InvalidArgument for a key that names none, or values that contradict each other
  FamilyAtSpin with(const std::vector<ParameterValue>& values) const;
};

/// The model of them: a MatricesModel, or where coordinates have no mass a CondensedModel. @throws LawBroken
std::shared_ptr<const ModelKind> model_of(FamilyAtSpin matrices);

/// What a family says to a sweep over its spin.
SpinSource spin_source_of(std::shared_ptr<const SpinFamily> family, std::vector<OrbitCoordinates> places,
                          std::vector<OrbitCoordinates> transverse);

}  // namespace gyromode
