#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode {

/// The columns that lines for people keep to: those of a terminal.
inline constexpr std::size_t line_columns = 80;

/// The columns that UTF-8 text takes: a column a code point, none for marks that combine with the letter before them.
std::size_t columns_of(std::string_view text);
/// Text in lines of up to so many columns, parted at blanks; a word that is longer is a line of its own.
std::vector<std::string> wrapped(std::string_view text, std::size_t columns);
/// The same as one text, every line but the first after `indent` blanks.
std::string wrapped_with_indent(std::string_view text, std::size_t columns, std::size_t indent);

}  // namespace gyromode
