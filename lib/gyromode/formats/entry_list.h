#pragma once

#include "gyromode/formats/matrix_file.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace gyromode::io {

/// A table of three columns (row, column, value; Abaqus' FORMAT=COORDINATE, CalculiX' .sti and .mas) or five (node,
/// direction, node, direction, value; Abaqus' MATRIX INPUT) as a matrix; a first line of sizes is passed over. Where no
/// pair is given both ways it is symmetric, or skew where nothing is on the diagonal. Labels of five columns are
/// "12.3", in the order of nodes. Nothing where the table is no such list: indices that are no whole numbers from 1, an
/// entry given twice, or a square table that is a symmetric or skew matrix as it stands. Throws Unreadable where the
/// first line may be either.
std::optional<NamedMatrix> entry_list(const std::vector<std::vector<double>>& rows, const std::filesystem::path& name,
                                      std::optional<Index> most);

}  // namespace gyromode::io
