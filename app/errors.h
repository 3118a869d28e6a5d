#pragma once

#include "gyromode/base/error.h"

#include <functional>

namespace gyromode::app {

/// Wrong usage found after parsing.
class UsageError : public InvalidArgument {
 public:
  using InvalidArgument::InvalidArgument;
};

/// Runs a verb, and turns what it throws into one line on stderr and the exit code that belongs to it.
int guarded(const std::function<ExitCode()>& verb);

}  // namespace gyromode::app
