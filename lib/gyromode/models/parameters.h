#pragma once

#include "gyromode/base/quantity.h"

#include <optional>
#include <string>
#include <vector>

namespace gyromode {

/// A number that a model is made of, by the dotted key that model files have for it, arrays from 0: "spin",
/// "body.inertia[2]", "cable[0].length", "stiffness[0][1]".
struct Parameter {
  std::string key;                     ///< dotted
  std::optional<Dimension> dimension;  ///< what it measures; nothing where units are the user's own (entries of matrices)
  double value = 0;                    ///< SI
};

/// A value for the parameters that `key` names.
struct ParameterValue {
  std::string key;   ///< dotted; [*] stands for every item
  double value = 0;  ///< SI
};

/// Values that some parameters of a model take together: `keys` as in keys_of().
struct ParameterAxis {
  std::string keys;            ///< dotted, commas between several that share the values
  std::vector<double> values;  ///< SI, ascending
};

}  // namespace gyromode
