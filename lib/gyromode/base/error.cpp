#include "gyromode/base/error.h"

#include <fmt/format.h>

namespace gyromode {

namespace {

// One line, whatever a file name holds.
std::string printable(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
  }
  return text;
}

std::string place_and_message(const std::filesystem::path& file, std::size_t line, std::size_t column, const std::string& message) {
  if (line == 0) return fmt::format("{}: {}", file.string(), message);
  if (column == 0) return fmt::format("{}:{}: {}", file.string(), line, message);
  return fmt::format("{}:{}:{}: {}", file.string(), line, column, message);
}

}  // namespace

Unreadable::Unreadable(const std::filesystem::path& file, std::size_t line, std::size_t column, const std::string& message)
    : Error(ExitCode::unreadable_input, printable(place_and_message(file, line, column, message))) {}

LawBroken::LawBroken(const std::filesystem::path& file, std::size_t line, std::size_t column, const std::string& message)
    : Error(ExitCode::broken_law, printable(place_and_message(file, line, column, message))), located_(true) {}

LawBroken LawBroken::of(std::string_view matrix, const std::string& message) {
  LawBroken e(message);
  e.matrix_ = matrix;
  return e;
}

}  // namespace gyromode
