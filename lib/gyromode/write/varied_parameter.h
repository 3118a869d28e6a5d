#pragma once

#include "gyromode/write/document.h"

#include <string>

namespace gyromode::io {

/// A number of the model that is varied, as people see it: a frequency in the unit asked for, all else in SI.
class VariedParameter {
 public:
  VariedParameter(const Model& model, std::string keys, FrequencyUnit unit);

  /// "spin [rpm]", "bearing[*].kxx [N/m]"; the keys alone where nothing is known of what they measure.
  std::string title() const;
  bool is_frequency() const { return frequency_; }
  /// Of a value in SI.
  double shown(double value) const { return frequency_ ? in_unit(value, unit_) : value; }

 private:
  std::string keys_, unit_name_;
  bool frequency_ = false;
  FrequencyUnit unit_;
};

}  // namespace gyromode::io
