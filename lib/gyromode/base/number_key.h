#pragma once

#include "gyromode/base/quantity.h"

#include <string_view>

namespace gyromode {

/// A key of one part of a model in model files, what it measures, and how it is written there.
struct NumberKey {
  enum class Form {
    one,                   ///< a number
    optional,              ///< a number; left out: as the part has it
    optional_or_infinite,  ///< likewise, or inf
    one_or_two,            ///< a number for both, or an array of two
    on_axis_3,             ///< a place [0, 0, z], of which z is kept
    several,               ///< an array
    several_or_infinite,   ///< an array whose items may be infinite
    symmetric              ///< three principal values, or the rows of a symmetric 3 × 3 matrix
  };
  std::string_view key;
  Dimension dimension;
  Form form = Form::one;
  bool may_be_zero = false;  ///< of one_or_two: 0 where it is left out
};

}  // namespace gyromode
