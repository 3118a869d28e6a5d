#include "grids.h"

#include "errors.h"
#include "input.h"

#include "gyromode/base/number.h"
#include "gyromode/base/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode::app {

Vector frequency_grid(const std::string& option, const std::string& text) {
  const std::size_t first = text.find(':'), second = first == std::string::npos ? first : text.find(':', first + 1);
  if (second == std::string::npos) throw UsageError(fmt::format("{} {}: A:B:N was expected, such as 1Hz:50Hz:200", option, text));
  const double from = frequency_option(option, text.substr(0, first)),
               to = frequency_option(option, text.substr(first + 1, second - first - 1));
  const double a = std::min(from, to), b = std::max(from, to);
  const auto n = whole_number(text.substr(second + 1));
  if (!n || *n < 2 || *n > 1000000)
    throw UsageError(fmt::format("{} {}: a number of points from 2 to 1000000 was expected at the end", option, text));
  if (!(a >= 0) || !(b > a)) throw UsageError(fmt::format("{} {}: two different frequencies ≥ 0 were expected", option, text));
  return Vector::LinSpaced(static_cast<Index>(*n), a, b);
}

double time_option(const std::string& option, const std::string& text) {
  const auto value = parse_quantity(text, Dimension::time);
  if (!value) throw UsageError(fmt::format("{} {}: '{}' is no time: {} was expected", option, text, text, form_of(Dimension::time)));
  return *value;
}

Vector time_grid(double until, double step) {
  constexpr double most_rows = 5e6;
  if (!(until >= 0) || !std::isfinite(until)) throw UsageError(fmt::format("--until {}: a time ≥ 0 was expected", until));
  if (!(step > 0) || !std::isfinite(step))
    throw UsageError(fmt::format("--step {}: a step above 0 was expected, so that times increase", step));
  const double steps = std::floor(until / step * (1 + 1e-12));
  if (!(steps < most_rows)) {
    throw UsageError(
        fmt::format("--until {} --step {}: {:.3g} rows are more than the {:.0e} that are written", until, step, steps, most_rows));
  }
  Vector t(static_cast<Index>(steps) + 1);
  for (Index k = 0; k < t.size(); ++k) t(k) = static_cast<double>(k) * step;
  return t;
}

}  // namespace gyromode::app
