#pragma once

#include "gyromode/base/types.h"

#include <string>
#include <string_view>
#include <vector>

namespace gyromode {

/// Names of coordinates, one each.
using Labels = std::vector<std::string>;

/// q1 … qn.
Labels default_labels(Index n);

/// Throws LawBroken unless there are n, none empty, no two equal, without control characters.
void require_labels(const Labels& labels, Index n);
/// Those of some coordinates.
Labels labels_at(const Labels& labels, const std::vector<Index>& which);
bool has_control_character(std::string_view label);

}  // namespace gyromode
