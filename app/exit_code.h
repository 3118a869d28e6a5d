#pragma once

namespace gyromode::app {

/// What the program returns (docs/results.md).
enum ExitCode {
  done = 0,
  wrong_usage = 1,
  unreadable_input = 2,
  broken_law = 3,
  not_certified = 4,
  internal_error = 70,
};

}  // namespace gyromode::app
