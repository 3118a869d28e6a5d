#pragma once

#include "gyromode/formats/matrix_file.h"

namespace gyromode::io {

/// MATLAB files, v4 to v7.3, by libmatio: real numeric arrays of two dimensions, dense or sparse; others are passed
/// over.
bool is_matlab(std::string_view bytes);
std::vector<NamedMatrix> read_matlab(std::string_view bytes, const std::filesystem::path& file, std::optional<Index> most);
/// A file of v5.
void write_matlab(const std::filesystem::path& file, const std::vector<NamedMatrix>& matrices);

}  // namespace gyromode::io
