#pragma once

#include "gyromode/models/parameters.h"
#include "gyromode/modes/modes.h"
#include "gyromode/sweep/critical_speeds.h"

#include <limits>
#include <string>
#include <vector>

namespace gyromode {

class ModelKind;

/// How the roots of a result change with one number of the model.
struct Sensitivity {
  Parameter parameter;        ///< its key, dimension and value p
  std::vector<double> slope;  ///< ∂ω/∂p of every root of the result, SI; not a number where it is not known
  std::vector<double> error;  ///< on it, to first order
  std::string reason;         ///< why it is known of no root; empty where it is

  /// p/ω ∂ω/∂p of root k at ω.
  double relative(std::size_t k, double omega) const {
    return omega > 0 ? parameter.value * slope[k] / omega : std::numeric_limits<double>::quiet_NaN();
  }
};

/// ∂ω/∂p of modes with shapes, for the parameters named (all that have a meaning of their own where none are): by the
/// derivative of the model's matrices, or of its impedance, at fixed ω and the shapes (theory (T15)); double modes by
/// the small pencil of all of them, ascending.
/// @throws InvalidArgument for a key that names none, or modes without shapes
std::vector<Sensitivity> sensitivities(const ModelKind& model, const std::vector<Mode>& modes, const std::vector<std::string>& keys);

/// ∂Ω/∂p of critical speeds of a model whose speed has the key `speed`.
std::vector<Sensitivity> sensitivities(const ModelKind& model, const CriticalSpeeds& found, const std::string& speed,
                                       const std::vector<std::string>& keys);

}  // namespace gyromode
