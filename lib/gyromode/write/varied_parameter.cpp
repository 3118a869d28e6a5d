#include "gyromode/write/varied_parameter.h"

#include "gyromode/base/quantity.h"
#include "gyromode/models/parameter_keys.h"

#include <fmt/format.h>

namespace gyromode::io {

VariedParameter::VariedParameter(const Model& model, std::string keys, FrequencyUnit unit) : keys_(std::move(keys)), unit_(unit) {
  const auto dimension = require_parameter(*model.body, keys_).dimension;
  frequency_ = dimension == Dimension::frequency;
  if (dimension) unit_name_ = frequency_ ? to_string(unit) : unit_of(*dimension);
}

std::string VariedParameter::title() const { return unit_name_.empty() ? keys_ : fmt::format("{} [{}]", keys_, unit_name_); }

}  // namespace gyromode::io
