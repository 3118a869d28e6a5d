#pragma once

#include "gyromode/base/labels.h"

#include <filesystem>
#include <string_view>

namespace gyromode::io {

/// Labels from a text file: one a line, or several parted by commas (quotes as in CSV); blank lines and lines that
/// begin with '#' are passed over. Throws Unreadable where there are none.
Labels read_labels(const std::filesystem::path& file);
Labels parse_labels(std::string_view text, const std::filesystem::path& file);

}  // namespace gyromode::io
