#pragma once

#include "gyromode/base/types.h"

#include <string>

namespace gyromode::app {

/// "A:B:N": N frequencies from A to B, both included; each bound with its own unit. Throws UsageError.
Vector frequency_grid(const std::string& option, const std::string& text);

/// 0, step, 2 step, … up to `until`. Throws UsageError.
/// A time as on the command line: a bare number is in s; 20ms, 2min. Throws UsageError naming the option.
double time_option(const std::string& option, const std::string& text);
Vector time_grid(double until, double step);

}  // namespace gyromode::app
