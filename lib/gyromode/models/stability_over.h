#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/models/parameter_keys.h"

#include <vector>

namespace gyromode {

/// The verdict of a model over a grid of one or two of its parameters, with the critical values along the first
/// (map_stability()). Where the values make no model, as they break a law, the point says which. Throws InvalidArgument
/// where a key names no parameter.
StabilityMap stability_over(const ModelKind& model, const std::vector<ParameterAxis>& axes, const Progress& progress = {});

}  // namespace gyromode
