#pragma once

#include <filesystem>
#include <string_view>

namespace gyromode::io {

/// Writes `content` to `file` so that an existing file is replaced only by a complete one: beside it first, then
/// renamed. Throws Unreadable where the place cannot be written.
void write_file(const std::filesystem::path& file, std::string_view content);

}  // namespace gyromode::io
