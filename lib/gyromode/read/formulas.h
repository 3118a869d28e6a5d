#pragma once

#include "gyromode/base/quantity.h"
#include "gyromode/models/parameters.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode::io {

/// The [parameters] of a model file, and formulas of them: numbers, + − * / ^, parentheses, the functions sin cos tan
/// asin acos atan atan2 sinh cosh tanh sqrt exp log log10 abs min max, and pi (muParser). Nothing is assigned, and no
/// code is run.
class Formulas {
 public:
  /// A formula that is none: what and, from 1, where in the text.
  struct Fault {
    std::string message;
  };

  /// Adds a parameter, of a value in SI. @returns a fault where the name is none or taken
  std::optional<Fault> add(const std::string& name, double value, std::optional<Dimension> dimension);
  /// The value of a formula; a fault where it is none, or not finite.
  struct Value {
    double value = 0;
    std::optional<Fault> fault;
  };
  Value evaluate(const std::string& text) const;
  /// In the order of the file.
  const std::vector<Parameter>& parameters() const { return parameters_; }

 private:
  std::vector<Parameter> parameters_;
};

}  // namespace gyromode::io
