#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode::io {

/// A row of a CSV file with the line where it stands.
struct CsvRow {
  std::size_t line = 0;
  std::vector<std::string> fields;  ///< blanks around them taken off, quotes of RFC 4180 undone
};

/// The rows of a CSV text (a byte order mark before it, semicolons for commas where its first row has only those) that
/// are not blank and do not start with '#'. Throws Unreadable for a quote that is not closed on its line.
std::vector<CsvRow> csv_rows(std::string_view text, const std::filesystem::path& file);

/// A field as RFC 4180 quotes it, and also where csv_rows() would take off blanks, a byte order mark, a comment, or
/// semicolons for commas.
std::string csv_field(const std::string& s);

}  // namespace gyromode::io
