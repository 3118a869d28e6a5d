#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gyromode::io {

/// The whole content of a file. Throws Unreadable where it is missing, a directory, unreadable, beyond 4 GiB (1 GiB
/// where it is no regular file: a pipe, a device), or holds a NUL byte, which is read no further: text has none. `what`
/// names what was expected in the message ("Matrix Market", "TOML").
/// The same of a file of any bytes.
std::string read_bytes(const std::filesystem::path& file, std::string_view what);

std::string read_text(const std::filesystem::path& file, std::string_view what);

/// The first 4096 bytes of a regular file; empty of anything else.
std::string start_of(const std::filesystem::path& file);

/// A piece of a file as messages show it: 40 characters at most, and nothing that a terminal would obey.
std::string shown(std::string_view piece);

}  // namespace gyromode::io
