#pragma once

#include "gyromode/motion/state.h"
#include "gyromode/system/laws.h"

#include <filesystem>
#include <string_view>

namespace gyromode::io {

/// Initial displacements and velocities from a CSV file with the columns label,q,qdot: each label of the model once, in
/// any order; SI, rad. Throws Unreadable with line and value: a column that is missing, an unknown label (the nearest
/// is named), one given twice or left out, a field that is no finite number.
State read_initial_state(const std::filesystem::path& file, const Labels& labels);
State parse_initial_state(std::string_view text, const std::filesystem::path& name, const Labels& labels);

/// Times from a text file, one a line (or the first column of a CSV with the heading t): finite, ≥ 0, increasing.
Vector read_times(const std::filesystem::path& file);
Vector parse_times(std::string_view text, const std::filesystem::path& name);

}  // namespace gyromode::io
