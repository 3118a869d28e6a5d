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

// Semicolons where the first line has one outside quotes and no comma: spreadsheets write them where commas are
// decimal.
char separator_of(std::string_view line) {
  char found = ',';
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == ',') return ',';
    if (line[i] == ';') found = ';';
    if (line[i] == '"') i = std::min(line.find('"', i + 1), line.size() - 1);
  }
  return found;
}

// Takes the quoted field at the start of `rest`, up to the separator or the end.
std::string quoted_field(std::string_view& rest, char separator, const Lines& lines) {
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
  if (!rest.empty() && rest.front() != separator)
    lines.fail(fmt::format("'{}' after a closing quote, where a {} was expected", shown(rest), separator == ',' ? "comma" : "semicolon"));
  return field;
}

}  // namespace

std::vector<CsvRow> csv_rows(std::string_view text, const std::filesystem::path& file) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  std::vector<CsvRow> rows;
  char separator = ',';
  for (Lines lines(text, file); lines.next();) {
    std::string_view rest = lines.line();
    if (rest.empty() || rest.front() == '#') continue;
    if (rows.empty()) separator = separator_of(rest);
    CsvRow row{lines.number(), {}};
    for (bool more = true; more;) {
      rest = trimmed(rest);
      if (!rest.empty() && rest.front() == '"') {
        row.fields.push_back(quoted_field(rest, separator, lines));
      } else {
        const std::size_t end = std::min(rest.find(separator), rest.size());
        row.fields.emplace_back(trimmed(rest.substr(0, end)));
        rest.remove_prefix(end);
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
      s.find_first_of(",;\"\r\n") == std::string::npos && trimmed(s) == s && !s.starts_with('#') && !s.starts_with(byte_order_mark);
  if (plain) return s;
  std::string quoted = "\"";
  for (const char c : s) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace gyromode::io
