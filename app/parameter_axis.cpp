#include "parameter_axis.h"

#include "errors.h"

#include "gyromode/base/error.h"
#include "gyromode/base/number.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/models/parameter_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode::app {

AxisText taken_apart(const std::string& option, const std::string& text, const std::string& example) {
  constexpr std::int64_t most = 100000;
  const std::size_t equals = text.rfind('='), first = text.find(':', equals),
                    second = first == std::string::npos ? first : text.find(':', first + 1);
  if (equals == std::string::npos || second == std::string::npos)
    throw UsageError(fmt::format("{} {}: KEY=A:B:N was expected, such as {}", option, text, example));
  const auto n = whole_number(text.substr(second + 1));
  if (!n || *n < 2 || *n > most)
    throw UsageError(fmt::format("{} {}: a number of values from 2 to {} was expected at the end", option, text, most));
  return {option, text, text.substr(0, equals), text.substr(equals + 1, first - equals - 1), text.substr(first + 1, second - first - 1),
          *n};
}

ParameterAxis axis_of(const Model& model, const AxisText& text, Spacing spacing) {
  const Parameter parameter = [&] {
    try {
      return require_parameter(*model.body, text.keys);
    } catch (const InvalidArgument& e) {
      throw UsageError(fmt::format("{}: {}", text.option, e.what()));
    }
  }();
  const auto bound = [&](const std::string& end) {
    const auto value = value_of(parameter, end);
    if (!value)
      throw UsageError(
          fmt::format("{} {}: '{}' is no number in SI or with a unit that fits '{}'", text.option, text.whole, end, text.keys));
    return *value;
  };
  const double from = bound(text.from), to = bound(text.to);
  if (from == to || !std::isfinite(to - from))
    throw UsageError(fmt::format("{} {}: two different finite bounds were expected", text.option, text.whole));
  const double a = std::min(from, to), b = std::max(from, to);  // 30:10:5 is 10:30:5
  const bool logarithmic = spacing == Spacing::logarithmic;
  if (logarithmic && !(a > 0))
    throw UsageError(fmt::format("{} {}: bounds above 0 were expected, as the values are spaced logarithmically", text.option, text.whole));
  ParameterAxis axis{text.keys, {}};
  for (std::int64_t k = 0; k < text.values; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(text.values - 1);
    axis.values.push_back(k + 1 == text.values ? b : logarithmic ? a * std::pow(b / a, t) : a + (b - a) * t);
  }
  return axis;
}

}  // namespace gyromode::app
