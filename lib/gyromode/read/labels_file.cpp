#include "gyromode/read/labels_file.h"

#include "gyromode/base/error.h"
#include "gyromode/formats/csv.h"
#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <unordered_map>

namespace gyromode::io {

Labels parse_labels(std::string_view text, const std::filesystem::path& file) {
  Labels labels;
  std::unordered_map<std::string, std::size_t> first;
  for (const CsvRow& row : csv_rows(text, file)) {
    for (const std::string& label : row.fields) {
      if (label.empty()) throw Unreadable(file, row.line, 0, "an empty label: a name was expected");
      if (has_control_character(label))
        throw Unreadable(file, row.line, 0,
                         fmt::format("label '{}' has a control character: a name that prints was expected", shown(label)));
      const auto [at, is_new] = first.emplace(label, row.line);
      if (!is_new)
        throw Unreadable(file, row.line, 0, fmt::format("label '{}' is given a second time (first on line {})", label, at->second));
      labels.push_back(label);
    }
  }
  if (labels.empty()) throw Unreadable(file, "no labels: one a line was expected");
  return labels;
}

Labels read_labels(const std::filesystem::path& file) { return parse_labels(read_text(file, "labels"), file); }

}  // namespace gyromode::io
