#include "gyromode/formats/csv.h"

#include "gyromode/formats/text_lines.h"

namespace gyromode::io {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::string_view trimmed(std::string_view s) {
  constexpr std::string_view blanks = " \t";
  s.remove_prefix(std::min(s.find_first_not_of(blanks), s.size()));
  return s.substr(0, s.find_last_not_of(blanks) + 1);
}

// Takes the quoted field at the start of `rest`, up to the comma or the end.
std::string quoted_field(std::string_view& rest, const Lines& lines) {
  std::string field;
  std::size_t i = 1;
  for (;; ++i) {
    if (i >= rest.size()) lines.fail("a quote is not closed on its line");
    if (rest[i] != '"') {
      field += rest[i];
    } else if (i + 1 < rest.size() && rest[i + 1] == '"') {
      field += '"';
      ++i;
    } else {
      break;
    }
  }
  rest = trimmed(rest.substr(i + 1));
  if (!rest.empty() && rest.front() != ',') lines.fail(fmt::format("'{}' after a closing quote, where a comma was expected", shown(rest)));
  return field;
}

}  // namespace

std::vector<CsvRow> csv_rows(std::string_view text, const std::filesystem::path& file) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  std::vector<CsvRow> rows;
  for (Lines lines(text, file); lines.next();) {
    std::string_view rest = lines.line();
    if (rest.empty() || rest.front() == '#') continue;
    CsvRow row{lines.number(), {}};
    for (bool more = true; more;) {
      rest = trimmed(rest);
      if (!rest.empty() && rest.front() == '"') {
        row.fields.push_back(quoted_field(rest, lines));
      } else {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        row.fields.emplace_back(trimmed(rest.substr(0, comma)));
        rest.remove_prefix(comma);
      }
      more = !rest.empty();
      if (more) rest.remove_prefix(1);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string csv_field(const std::string& s) {
  const bool plain =
      s.find_first_of(",\"\r\n") == std::string::npos && trimmed(s) == s && !s.starts_with('#') && !s.starts_with(byte_order_mark);
  if (plain) return s;
  std::string quoted = "\"";
  for (const char c : s) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace gyromode::io
