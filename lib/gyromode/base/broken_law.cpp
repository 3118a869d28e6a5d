#include "gyromode/base/broken_law.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode {

std::optional<BrokenLaw> not_positive(const char* key, const char* unit, double value) {
  if (value > 0 && std::isfinite(value)) return std::nullopt;
  return BrokenLaw{key, fmt::format("'{}' must be above 0: it is {:.6g} {}", key, value, unit)};
}

std::optional<BrokenLaw> negative(const char* key, const char* unit, double value) {
  if (value >= 0 && std::isfinite(value)) return std::nullopt;
  return BrokenLaw{key, fmt::format("'{}' must not be below 0: it is {:.6g} {}", key, value, unit)};
}

std::optional<BrokenLaw> not_a_finite_number(const char* key, double value) {
  if (std::isfinite(value)) return std::nullopt;
  return BrokenLaw{key, fmt::format("'{}' must be finite: it is {}", key, value)};
}

std::optional<BrokenLaw> first_broken(std::initializer_list<std::optional<BrokenLaw>> laws) {
  for (const auto& b : laws) {
    if (b) return b;
  }
  return std::nullopt;
}

}  // namespace gyromode
