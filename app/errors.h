#pragma once

#include <functional>
#include <stdexcept>

namespace gyromode::app {

/// Wrong usage found after parsing: exit 1.
class UsageError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Runs a verb, and turns what it throws into one line on stderr and the exit code that belongs to it.
int guarded(const std::function<int()>& verb);

}  // namespace gyromode::app
