#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/models/model.h"
#include "gyromode/models/parameters.h"

#include <string>
#include <vector>

namespace gyromode {

/// Values that some parameters of a model take together: `keys` as in keys_of().
struct ParameterAxis {
  std::string keys;
  std::vector<double> values;  ///< SI, ascending
};

/// The verdict of a model over a grid of one or two of its parameters, with the critical values along the first (map_stability()). Where the values make no model, as they break a law, the point
/// says which. Throws InvalidArgument where a key names no parameter.
StabilityMap stability_over(const ModelKind& model, const std::vector<ParameterAxis>& axes, const Progress& progress = {});

}  // namespace gyromode
