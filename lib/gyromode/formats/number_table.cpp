#include "gyromode/formats/number_table.h"

#include "gyromode/base/number.h"
#include "gyromode/formats/entries.h"
#include "gyromode/formats/entry_list.h"
#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode::io {

namespace {

std::string_view trimmed(std::string_view s) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = s.find_first_not_of(blanks);
  return first == std::string_view::npos ? std::string_view() : s.substr(first, s.find_last_not_of(blanks) - first + 1);
}

char mark_of(std::string_view line) {
  return line.find(';') != std::string_view::npos ? ';' : line.find(',') != std::string_view::npos ? ',' : ' ';
}

std::vector<std::string_view> fields_of(std::string_view line, char mark) {
  std::vector<std::string_view> fields;
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
    if (end == std::string_view::npos) {
      if (fields.size() > 1 && fields.back().empty()) fields.pop_back();  // a mark at the end of the line
      return fields;
    }
    at = end + 1;
  }
}

std::string_view unquoted(std::string_view s) {
  return s.size() >= 2 && s.front() == '"' && s.back() == '"' ? s.substr(1, s.size() - 2) : s;
}

// In quotes or not; between semicolons the comma may be the decimal mark.
Parsed number(std::string_view field, char mark) {
  const std::string_view bare = unquoted(field);
  if (mark != ';' || std::count(bare.begin(), bare.end(), ',') != 1) return parse_real(bare);
  std::string with_point(bare);
  with_point[with_point.find(',')] = '.';
  return parse_real(with_point);
}
bool is_number(std::string_view field, char mark) { return number(field, mark).outcome != Parsed::not_a_number; }

// '#' anywhere; '%', "//" and "**" at the start of a line.
std::string_view without_comment(std::string_view line) {
  line = trimmed(line);
  if (line.starts_with('%') || line.starts_with("//") || line.starts_with("**")) return {};
  return trimmed(line.substr(0, line.find('#')));
}

// The lines of numbers as they stand, and the names of a heading line.
struct Table {
  std::vector<std::vector<double>> rows;
  Labels heading;
  bool named_rows = false;
};

bool whole_and_different(const std::vector<double>& row) {
  std::vector<double> sorted = row;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end() &&
         std::all_of(row.begin(), row.end(), [](double x) { return x >= 0 && x == std::floor(x); });
}

// A first line of whole numbers above a square table: names of its columns (node numbers), and of its rows where a
// first column repeats them, as pandas writes it.
void take_numbered_heading(Table& t) {
  const std::size_t rows = t.rows.size(), columns = t.rows.front().size();
  if (rows != columns + 1 || !t.heading.empty() || !whole_and_different(t.rows.front())) return;
  for (const double x : t.rows.front()) t.heading.push_back(fmt::format("{}", x));
  t.rows.erase(t.rows.begin());
}

}  // namespace

namespace {

// What is no table at all, by its first line.
void require_no_other_format(std::string_view line, const std::filesystem::path& name) {
  if (line.starts_with('{') || line.starts_with("[{")) throw Unreadable(name, "is JSON: a matrix file was expected (docs/formats.md)");
  if (line.find(" = ") != std::string_view::npos || (line.starts_with('[') && line.ends_with(']')))
    throw Unreadable(name, fmt::format("is a model file, or other TOML, and no matrix: gyromode modes {} was expected", name.string()));
}

Table table_of(std::string_view text, const std::filesystem::path& name, std::optional<Index> most) {
  Table t;
  for (std::size_t line_number = 1; !text.empty(); ++line_number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = without_comment(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.empty()) continue;
    if (t.rows.empty() && t.heading.empty()) require_no_other_format(line, name);
    const char mark = mark_of(line);
    std::vector<std::string_view> fields = fields_of(line, mark);
    const bool any_number = std::any_of(fields.begin(), fields.end(), [&](std::string_view f) { return is_number(f, mark); });
    if (t.rows.empty() && t.heading.empty() && (!any_number || (fields.size() > 1 && fields.front().empty()))) {
      for (const std::string_view f : fields) t.heading.emplace_back(unquoted(f));
      t.named_rows = t.heading.front().empty();
      continue;
    }
    if (t.rows.empty() && !t.named_rows) t.named_rows = fields.size() > 1 && !is_number(fields.front(), mark);
    if (t.named_rows) fields.erase(fields.begin());
    std::vector<double> row;
    for (const std::string_view f : fields) {
      const Parsed p = number(f, mark);
      if (p.outcome != Parsed::ok)
        throw Unreadable(
            name, line_number, 0,
            fmt::format("'{}' is no finite number: a table of numbers was expected, a row a line, or a file of another format that "
                        "is read (docs/formats.md)",
                        shown(f)));
      row.push_back(p.value);
    }
    if (!t.rows.empty() && row.size() != t.rows.front().size())
      throw Unreadable(name, line_number, 0,
                       fmt::format("{} numbers: {} were expected, as in the first row", row.size(), t.rows.front().size()));
    t.rows.push_back(std::move(row));
    const std::size_t columns = t.rows.front().size();
    if (most && columns != 3 && columns != 5 && static_cast<Index>(std::max(t.rows.size(), columns)) > *most + 1)
      Entries(name, most).require_size(static_cast<Index>(t.rows.size()), static_cast<Index>(columns), 1, line_number);
  }
  return t;
}

}  // namespace

NamedMatrix parse_number_table(std::string_view text, const std::filesystem::path& name, std::optional<Index> most) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  Table t = table_of(text, name, most);
  if (t.rows.empty()) throw Unreadable(name, "has no numbers: a matrix was expected");
  if (!t.named_rows && t.heading.empty()) {
    if (auto list = entry_list(t.rows, name, most)) return std::move(*list);
  }
  take_numbered_heading(t);
  const auto rows = static_cast<Index>(t.rows.size()), columns = static_cast<Index>(t.rows.front().size());
  Entries(name, most).require_size(rows, columns, rows * columns);
  NamedMatrix found{name.stem().string(), Matrix(rows, columns), {}};
  for (Index i = 0; i < rows; ++i) {
    for (Index j = 0; j < columns; ++j) found.matrix(i, j) = t.rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  if (static_cast<Index>(t.heading.size()) == columns + 1) t.heading.erase(t.heading.begin());  // of the column of names
  if (static_cast<Index>(t.heading.size()) == columns) found.labels = std::move(t.heading);
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
