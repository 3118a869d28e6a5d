#pragma once

#include "gyromode/base/labels.h"

#include <string>
#include <vector>

namespace gyromode {

/// A reflection R (n × n, R² = 1) in words, where it is simple in the given coordinates: one that reverses some,
/// exchanges others (a mirror or a half-turn of a model written node by node), or one mirror line through pairs of
/// coordinates (axes that are not those of the body). Otherwise the sizes of its groups.
std::string in_words(const Matrix& reflection, const Labels& labels);

/// The labels at some positions.
Labels chosen(const Labels& labels, const std::vector<Index>& at);

}  // namespace gyromode
