#pragma once

#include "gyromode/base/error.h"
#include "gyromode/base/number_key.h"
#include "gyromode/models/parameter_keys.h"
#include "gyromode/models/parameters.h"

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace gyromode {

/// Parameters of models that are made of parts, from the numbers that each part has: each_number(part, see), found by
/// the type of the part.

/// Calls see(key, dimension, number, mirror image of it or null) for every number of a part of that name.
template <class Part, class See>
void each_parameter_of(Part& part, const std::string& name, See&& see) {
  double* const no_mirror = nullptr;
  each_number(part, [&](const NumberKey& k, std::span<double> numbers) {
    const std::string key = fmt::format("{}.{}", name, k.key);
    switch (k.form) {
      case NumberKey::Form::one:
      case NumberKey::Form::optional: see(key, k.dimension, numbers[0], no_mirror); break;
      case NumberKey::Form::optional_or_infinite:
        if (std::isfinite(numbers[0])) see(key, k.dimension, numbers[0], no_mirror);
        break;
      case NumberKey::Form::one_or_two:  // both by the key alone, where they are equal
        if (numbers[0] == numbers[1]) see(key, k.dimension, numbers[0], &numbers[1]);
        for (std::size_t i = 0; i < 2; ++i) see(fmt::format("{}[{}]", key, i), k.dimension, numbers[i], no_mirror);
        break;
      case NumberKey::Form::on_axis_3: see(key + "[2]", k.dimension, numbers[0], no_mirror); break;
      case NumberKey::Form::several:
      case NumberKey::Form::several_or_infinite:
        for (std::size_t i = 0; i < numbers.size(); ++i) see(fmt::format("{}[{}]", key, i), k.dimension, numbers[i], no_mirror);
        break;
      case NumberKey::Form::symmetric:  // a principal value by one index, any entry by two
        for (std::size_t i = 0; i < 3; ++i) see(fmt::format("{}[{}]", key, i), k.dimension, numbers[4 * i], no_mirror);
        for (std::size_t i = 0; i < 3; ++i) {
          for (std::size_t j = 0; j < 3; ++j)
            see(fmt::format("{}[{}][{}]", key, i, j), k.dimension, numbers[3 * i + j], &numbers[3 * j + i]);
        }
        break;
    }
  });
}

/// The same for every part of a list: "cable[0].length".
template <class Part, class See>
void each_parameter_of_all(std::vector<Part>& parts, const char* name, See&& see) {
  for (std::size_t i = 0; i < parts.size(); ++i) each_parameter_of(parts[i], fmt::format("{}[{}]", name, i), see);
}

/// `each(see)` calls see as above for every parameter of a model.
template <class Each>
std::vector<Parameter> listed_parameters(Each&& each) {
  std::vector<Parameter> all;
  each([&](const std::string& key, Dimension dimension, double& x, double*) { all.push_back({key, dimension, x}); });
  return all;
}

/// Sets them. Throws InvalidArgument for a key that names none, or two values for one.
template <class Each>
void set_parameters(Each&& each, const std::vector<ParameterValue>& values) {
  for (const ParameterValue& v : values) {
    bool any = false;
    each([&](const std::string& key, Dimension, double& x, double* mirror) {
      if (!names(v.key, key)) return;
      x = v.value;
      if (mirror) *mirror = v.value;
      any = true;
    });
    if (!any) throw InvalidArgument(fmt::format("'{}' is no parameter of the model", v.key));
  }
  for (const ParameterValue& v : values) {
    each([&](const std::string& key, Dimension, double& x, double*) {
      if (names(v.key, key) && x != v.value)
        throw InvalidArgument(fmt::format("'{}' is given two values at once: another key names it, too", key));
    });
  }
}

}  // namespace gyromode
