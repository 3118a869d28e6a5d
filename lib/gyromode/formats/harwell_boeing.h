#pragma once

#include "gyromode/formats/matrix_file.h"

namespace gyromode::io {

/// Harwell–Boeing and Rutherford–Boeing files: real (or integer) assembled matrices, symmetric, skew or unsymmetric.
/// ANSYS writes them by HBMAT.
bool is_harwell_boeing(std::string_view text);
NamedMatrix parse_harwell_boeing(std::string_view text, const std::filesystem::path& name, std::optional<Index> most);

}  // namespace gyromode::io
