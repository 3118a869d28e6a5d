#pragma once

#include "gyromode/formats/matrix_file.h"

namespace gyromode::io {

/// A NumPy array file (.npy, versions 1 to 3): float or integer, of either endian and order, of one or two dimensions;
/// a vector is a column.
bool is_npy(std::string_view bytes);
/// `may_be_empty`: an array of no numbers is one, too.
Matrix parse_npy(std::string_view bytes, const std::filesystem::path& name, std::optional<Index> most, bool may_be_empty = false);

/// Why it is no matrix of real numbers ("is complex"); empty where it is one.
std::string unfit_npy(std::string_view bytes, const std::filesystem::path& name);

/// A ZIP archive of them (.npz), stored or deflated; scipy.sparse's layout (csr, csc, coo) is one matrix.
bool is_npz(std::string_view bytes);
std::vector<NamedMatrix> parse_npz(std::string_view bytes, const std::filesystem::path& name, std::optional<Index> most);

/// The bytes of a .npy file of a matrix, float64, column by column; and of a .npz file of several.
std::string format_npy(const Matrix& a);
std::string format_npz(const std::vector<NamedMatrix>& matrices);

}  // namespace gyromode::io
