#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

namespace gyromode::io {

/// Input that cannot be read: missing, malformed, of the wrong type or unit, not finite, or of sizes that do not fit.
/// what() is one line, "file:line:column: message", where the message names the value met and what was expected.
class InputError : public std::runtime_error {
 public:
  /// line and column count from 1; 0 leaves them out.
  InputError(const std::filesystem::path& file, std::size_t line, std::size_t column, const std::string& message);
  InputError(const std::filesystem::path& file, const std::string& message) : InputError(file, 0, 0, message) {}
};

}  // namespace gyromode::io
