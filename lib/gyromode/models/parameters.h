#pragma once

#include "gyromode/base/quantity.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode {

class ModelKind;

/// A number that a model is made of, by the dotted key that model files have for it, arrays from 0: "spin", "body.inertia[2]", "cable[0].length", "stiffness[0][1]".
struct Parameter {
  std::string key;
  std::optional<Dimension> dimension;  ///< what it measures; nothing where units are the user's own (entries of matrices)
  double value = 0;                    ///< SI
};

/// A value for the parameters that `key` names.
struct ParameterValue {
  std::string key;
  double value = 0;
};

/// Whether `pattern` names `key`: the same, or the same but for [*] in the place of an index.
bool names(std::string_view pattern, std::string_view key);

/// The indices of "name[i]" or "name[i][j]", −1 for [*]; nothing where `pattern` is no such thing.
std::optional<std::vector<std::ptrdiff_t>> indices_of(std::string_view name, std::string_view pattern);

/// Keys that share one value: "a,b" is a and b.
std::vector<std::string> keys_of(const std::string& keys);

/// The first parameter that `keys` name. Throws InvalidArgument where one of the keys names none, with the nearest that the model lists.
Parameter require_parameter(const ModelKind& model, const std::string& keys);

/// A value for those keys as people write it: a number in SI, or with a unit of what they measure. Nothing where it is none.
std::optional<double> value_of(const Parameter& parameter, std::string_view text);

}  // namespace gyromode
