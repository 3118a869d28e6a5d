#pragma once

#include <string>
#include <vector>

namespace gyromode::bench {

/// Runs a command, its path first, with stdout and stderr to /dev/null, and waits for its end. Throws
/// std::runtime_error unless it exits with 0.
void run_to_end(const std::vector<std::string>& command);

}  // namespace gyromode::bench
