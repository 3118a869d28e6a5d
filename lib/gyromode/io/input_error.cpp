#include "gyromode/io/input_error.h"

#include <fmt/format.h>

namespace gyromode::io {

namespace {

// One line, whatever a file name holds.
std::string printable(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
  }
  return text;
}

std::string located(const std::filesystem::path& file, std::size_t line, std::size_t column, const std::string& message) {
  if (line == 0) return fmt::format("{}: {}", file.string(), message);
  if (column == 0) return fmt::format("{}:{}: {}", file.string(), line, message);
  return fmt::format("{}:{}:{}: {}", file.string(), line, column, message);
}

}  // namespace

InputError::InputError(const std::filesystem::path& file, std::size_t line, std::size_t column, const std::string& message)
    : std::runtime_error(printable(located(file, line, column, message))) {}

}  // namespace gyromode::io
