#pragma once

#include "gyromode/models/parameters.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode {

class ModelKind;

/// Whether `pattern` names `key`: the same, or the same but for [*] in the place of an index.
bool names(std::string_view pattern, std::string_view key);

/// The indices of "name[i]" or "name[i][j]", −1 for [*]; nothing where `pattern` is no such thing.
std::optional<std::vector<std::ptrdiff_t>> indices_of(std::string_view name, std::string_view pattern);

/// Keys that share one value: "a,b" is a and b.
std::vector<std::string> keys_of(const std::string& keys);

/// The first parameter that `keys` name. Throws InvalidArgument where one of the keys names none, with the nearest that
/// the model lists.
Parameter require_parameter(const ModelKind& model, const std::string& keys);

/// A value for those keys as people write it: a number in SI, or with a unit of what they measure. Nothing where it is
/// none.
std::optional<double> value_of(const Parameter& parameter, std::string_view text);

}  // namespace gyromode
