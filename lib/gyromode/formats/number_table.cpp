#include "gyromode/formats/number_table.h"

#include "gyromode/base/number.h"
#include "gyromode/formats/entries.h"
#include "gyromode/formats/entry_list.h"
#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode::io {

namespace {

std::string_view trimmed(std::string_view s) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = s.find_first_not_of(blanks);
  return first == std::string_view::npos ? std::string_view() : s.substr(first, s.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  const char mark = line.find(';') != std::string_view::npos ? ';' : line.find(',') != std::string_view::npos ? ',' : ' ';
  if (mark == ' ') {
    for (std::size_t at = 0; (at = line.find_first_not_of(" \t", at)) != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
      fields.push_back(line.substr(at, end - at));
      at = end;
    }
    return fields;
  }
  for (std::size_t at = 0;;) {
    const std::size_t end = line.find(mark, at);
    fields.push_back(trimmed(line.substr(at, end == std::string_view::npos ? end : end - at)));
    if (end == std::string_view::npos) return fields;
    at = end + 1;
  }
}

bool is_number(std::string_view s) { return parse_real(s).outcome != Parsed::not_a_number; }

std::string_view unquoted(std::string_view s) {
  return s.size() >= 2 && s.front() == '"' && s.back() == '"' ? s.substr(1, s.size() - 2) : s;
}

}  // namespace

NamedMatrix parse_number_table(std::string_view text, const std::filesystem::path& name, std::optional<Index> most) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  NamedMatrix found{name.stem().string(), {}, {}};
  std::vector<std::vector<double>> rows;
  bool named_rows = false;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = trimmed(text.substr(0, std::min(end, text.find('#'))));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.empty()) continue;
    std::vector<std::string_view> fields = fields_of(line);
    if (rows.empty() && found.labels.empty() && std::none_of(fields.begin(), fields.end(), is_number)) {
      for (const std::string_view f : fields) found.labels.emplace_back(unquoted(f));
      continue;
    }
    if (rows.empty()) named_rows = fields.size() > 1 && !is_number(fields.front());
    if (named_rows) fields.erase(fields.begin());
    std::vector<double> row;
    for (const std::string_view f : fields) {
      const Parsed p = parse_real(f);
      if (p.outcome != Parsed::ok)
        throw Unreadable(
            name, number, 0,
            fmt::format("'{}' is no finite number: a table of numbers was expected, a row a line, or a file of another format that "
                        "is read (docs/formats.md)",
                        shown(f)));
      row.push_back(p.value);
    }
    if (!rows.empty() && row.size() != rows.front().size())
      throw Unreadable(name, number, 0, fmt::format("{} numbers: {} were expected, as in the first row", row.size(), rows.front().size()));
    rows.push_back(std::move(row));
    const std::size_t columns = rows.front().size();
    if (most && columns != 3 && columns != 5 && static_cast<Index>(std::max(rows.size(), columns)) > *most)
      Entries(name, most).require_size(static_cast<Index>(rows.size()), static_cast<Index>(rows.front().size()), 1, number);
  }
  if (rows.empty()) throw Unreadable(name, "has no numbers: a matrix was expected");
  if (!named_rows) {
    if (auto list = entry_list(rows, name, most)) return std::move(*list);
  }
  Entries(name, most)
      .require_size(static_cast<Index>(rows.size()), static_cast<Index>(rows.front().size()),
                    static_cast<Index>(rows.size() * rows.front().size()));
  found.matrix.resize(static_cast<Index>(rows.size()), static_cast<Index>(rows.front().size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) found.matrix(static_cast<Index>(i), static_cast<Index>(j)) = rows[i][j];
  }
  // of the column of names
  if (static_cast<Index>(found.labels.size()) == found.matrix.cols() + 1) found.labels.erase(found.labels.begin());
  if (static_cast<Index>(found.labels.size()) != found.matrix.cols()) found.labels.clear();
  return found;
}

std::string format_number_table(const Matrix& a) {
  std::string text;
  for (Index i = 0; i < a.rows(); ++i) {
    for (Index j = 0; j < a.cols(); ++j) text += fmt::format("{}{}", j == 0 ? "" : ",", a(i, j));
    text += '\n';
  }
  return text;
}

}  // namespace gyromode::io
