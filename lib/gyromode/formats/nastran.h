#pragma once

#include "gyromode/formats/matrix_file.h"

namespace gyromode::io {

/// Direct matrix input of Nastran (DMIG, as EXTSEOUT and PUNCH write it): small, large and free field; real, single or
/// double; square (1), symmetric (6); rectangular ones (2, 9) are passed over. Rows and columns are the degrees of
/// freedom that the matrix names, in order of grid point and component; labels are "12.3", of scalar points "12".
bool is_dmig(std::string_view text);
std::vector<NamedMatrix> parse_dmig(std::string_view text, const std::filesystem::path& name, std::optional<Index> most);

/// OUTPUT4 of Nastran: text or binary of either endian; dense columns, sparse strings, and BIGMAT; real, single or
/// double.
bool is_op4(std::string_view bytes);
std::vector<NamedMatrix> parse_op4(std::string_view bytes, const std::filesystem::path& name, std::optional<Index> most);

}  // namespace gyromode::io
