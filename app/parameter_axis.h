#pragma once

#include "gyromode/models/model.h"

#include <cstdint>
#include <string>

namespace gyromode::app {

/// KEY=A:B:N or KEY,KEY=A:B:N, taken apart; what A and B are depends on the model.
struct AxisText {
  std::string option;  ///< "--vary"
  std::string whole, keys, from, to;
  std::int64_t values = 0;
};
/// Throws UsageError naming the option, the text and what was expected, with an example of the verb.
AxisText taken_apart(const std::string& option, const std::string& text, const std::string& example);

/// How values lie between the bounds.
enum class Spacing { equal, logarithmic };
/// The values of a parameter of the model, ascending. Throws UsageError for a key that names none, bounds in units that
/// do not fit, or, spaced logarithmically, not above 0.
ParameterAxis axis_of(const Model& model, const AxisText& text, Spacing spacing = Spacing::equal);

}  // namespace gyromode::app
