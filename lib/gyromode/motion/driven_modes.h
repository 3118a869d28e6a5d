#pragma once

#include "gyromode/modes/components.h"
#include "gyromode/motion/unit_masses.h"

#include <vector>

namespace gyromode {

/// Whether a force e^{jωt} drives a mode: `no` where the structure says so, the force and the mode having no coordinate in common; `undecided` where the force meets it by less than the error of
/// its shape, so that rounding of the matrices decides.
enum class Driven { no, undecided, yes };
std::string_view to_string(Driven d);

/// A mode as a steady force meets it.
struct DrivenMode {
  double omega = 0;
  double error = 0;          ///< bound on |δω|
  double participation = 0;  ///< |Xᴴf| / (√(XᴴMX) √(fᵀM⁻¹f)), of the span where modes coincide: from 0, not driven, to 1; does not depend on units. Of zero roots the same after cancellation
  double resolution = 0;     ///< the error of the participation: up to this it says nothing
  Driven driven = Driven::no;
};

/// Every mode of a system, ascending in ω; zero roots as one mode at 0, if there are any. `solved` is units.system solved, `force` in its coordinates.
std::vector<DrivenMode> driven_modes(const SolvedSystem& solved, const UnitMasses& units, const Vector& force);

}  // namespace gyromode
