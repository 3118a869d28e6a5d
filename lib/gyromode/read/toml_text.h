#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string_view>

namespace gyromode::io {

/// Levels of tables and arrays in a TOML text: parts of a header, parts of dotted keys, arrays and inline tables within
/// one another. A model needs five. toml++ builds and frees what is nested by recursion, so that a key of 100 000 parts
/// would exhaust the stack.
inline constexpr std::size_t deepest_toml = 64;

/// The text as a document. Throws Unreadable, with line and column, where it is empty, nested deeper than that, or not
/// TOML; `file` stands for it in messages.
toml::table parse_toml(std::string_view text, const std::filesystem::path& file);

}  // namespace gyromode::io
