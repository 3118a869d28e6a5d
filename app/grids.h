#pragma once

#include "gyromode/base/types.h"

#include <string>

namespace gyromode::app {

/// "A:B:N": N frequencies from A to B, both included; each bound with its own unit. Throws UsageError.
Vector frequency_grid(const std::string& option, const std::string& text);

/// 0, step, 2 step, … up to `until`. Throws UsageError.
Vector time_grid(double until, double step);

}  // namespace gyromode::app
