#pragma once

#include "gyromode/formats/matrix_file.h"

namespace gyromode::io {

/// A table of numbers, a row a line, parted by commas, semicolons, tabs or blanks. A first line of names are the labels
/// of the columns; names before the numbers of each line are left out. '#' begins a comment.
NamedMatrix parse_number_table(std::string_view text, const std::filesystem::path& name, std::optional<Index> most);

/// The text of one, commas, each number in the shortest form that reads back the same.
std::string format_number_table(const Matrix& a);

}  // namespace gyromode::io
