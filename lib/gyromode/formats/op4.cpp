// Format: MSC Nastran DMAP Programmer's Guide, module OUTPUT4. A column is a record (column, first row, words) with the
// values below that row; where the first row is 0 it holds strings, each with a header: L · 65536 + row, or with BIGMAT
// (rows written negative) the two numbers L and row; L counts words and the header, 1 + words of the string. A word has
// four bytes, in files of 64-bit integers eight, where every value is one word. In text files that Nastran writes dense
// columns count values.
#include "gyromode/base/number.h"
#include "gyromode/formats/entries.h"
#include "gyromode/formats/nastran.h"
#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

namespace gyromode::io {

namespace {

struct Header {
  Index columns = 0, rows = 0;
  int type = 2;  // 1 single, 2 double
  bool big = false, complex = false;
  std::string name;
  Index words = 2;  // a value takes
};

[[noreturn]] void fail(const std::filesystem::path& name, std::size_t line, const std::string& message) {
  throw Unreadable(name, line, 0, "OUTPUT4: " + message);
}

Header header_of(Index columns, Index rows, Index type, std::string_view written, const std::filesystem::path& name, std::size_t line) {
  Header h;
  h.columns = columns;
  h.big = rows < 0;
  h.rows = std::abs(rows);
  if (type < 1 || type > 4) fail(name, line, fmt::format("type {} of the matrix: 1 or 2 (real, single or double) was expected", type));
  h.complex = type > 2;
  h.type = type == 2 ? 2 : 1;
  h.words = h.type;
  for (const char c : written) {
    if (c > ' ') h.name += c;
  }
  return h;
}

// Of an order that serves nobody here.
bool beyond(const Header& h, std::optional<Index> most) { return most && std::max(h.rows, h.columns) > *most; }
std::string unfit(const Header& h) { return h.complex ? "is complex" : fmt::format("has {} rows and {} columns", h.rows, h.columns); }

// What both forms have in common: words of a column, from a source that gives whole numbers and values.
template <class Source>
void read_column(Source& from, const Header& h, Index column, Index first, Index words, Entries& entries) {
  const auto put = [&](Index row, Index count) {
    if (row < 1 || count < 0 || row + count - 1 > h.rows)
      from.fail(fmt::format("rows {} to {} of column {} are outside the matrix of {} rows", row, row + count - 1, column, h.rows));
    for (Index k = 0; k < count; ++k) {
      const double value = from.value(h.type);
      if (value != 0) entries.add(row - 1 + k, column - 1, value);
    }
  };
  if (first > 0) return put(first, from.values_of(words, h, first));
  for (Index left = words; left > 0;) {
    Index length = 0, row = 0;
    if (h.big) {
      length = from.whole() - 1;
      row = from.whole();
      left -= 2;
    } else {
      const Index packed = from.whole();
      length = packed / 65536 - 1;
      row = packed % 65536;
      left -= 1;
    }
    if (length < 1 || length > left)
      from.fail(fmt::format("a string of {} words in column {}, of which {} are left", length, column, left));
    put(row, length / h.words);
    left -= length;
    from.end_of_string();
  }
}

class TextSource {
 public:
  TextSource(std::string_view text, const std::filesystem::path& name) : rest_(text), name_(name) {}

  bool over() const { return rest_.find_first_not_of(" \r\n") == std::string_view::npos; }
  std::string_view line(std::string_view what) {
    if (rest_.empty()) fail(fmt::format("the file ends where {} was expected", what));
    const std::size_t end = rest_.find('\n');
    std::string_view l = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (!l.empty() && l.back() == '\r') l.remove_suffix(1);
    ++number_;
    return l;
  }
  [[noreturn]] void fail(const std::string& message) const { io::fail(name_, number_, message); }
  void format(FortranFormat f) { format_ = f; }
  // Numbers of eight columns (or parted by blanks).
  Index field(std::string_view l, std::size_t k) const {
    std::string_view text = 8 * k < l.size() ? l.substr(8 * k, 8) : std::string_view();
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    const auto value = whole_number(text);
    if (!value) fail(fmt::format("'{}' where a whole number eight columns wide was expected", shown(text)));
    return *value;
  }
  // The header of a string is a line of its own: one number of up to twelve columns, with BIGMAT two of eight.
  Index whole() {
    if (pending_) return *std::exchange(pending_, std::nullopt);
    const std::string_view l = line("the header of a string");
    const std::size_t first = l.find_first_not_of(' '), blank = first == std::string_view::npos ? first : l.find(' ', first);
    const bool one = blank == std::string_view::npos || l.find_first_not_of(' ', blank) == std::string_view::npos;
    if (!one) {
      pending_ = field(l, 1);
      return field(l, 0);
    }
    const auto value = first == std::string_view::npos ? std::nullopt : whole_number(l.substr(first, blank - first));
    if (!value) fail(fmt::format("'{}' where the header of a string was expected", shown(l)));
    return *value;
  }
  // Of a dense column of so many words in double precision: as many values as its lines hold, all of them or half.
  Index values_of(Index words, const Header& h, Index) const {
    if (h.type == 1) return words;
    std::string_view rest = rest_;
    Index values = 0;
    while (values < words && !rest.empty()) {
      std::string_view l = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(l.size() + 1, rest.size()));
      while (!l.empty() && (l.back() == ' ' || l.back() == '\r')) l.remove_suffix(1);
      if (l.find('.') == std::string_view::npos) break;  // the next column
      const auto width = static_cast<std::size_t>(format_.width);
      values += std::min<Index>(format_.count, static_cast<Index>((l.size() + width - 1) / width));
    }
    return values >= words ? words : words / 2;
  }
  // Lines up to the value that closes the matrix.
  void skip(const Header& h) {
    for (;;) {
      const std::string_view l = line("a column, or the column after the last,");
      if (l.find('.') != std::string_view::npos || l.size() < 24) continue;
      if (field(l, 0) > h.columns) break;
    }
    line("the value that closes the matrix");
  }
  double value(int) {
    const auto width = static_cast<std::size_t>(format_.width);
    if (at_ == 0 || at_ == format_.count) {
      values_ = line("a value");
      at_ = 0;
    }
    const std::size_t first = static_cast<std::size_t>(at_) * width;
    const std::string_view text = first < values_.size() ? values_.substr(first, width) : std::string_view();
    const auto value = fortran_number(text);
    if (!value) fail(fmt::format("'{}' where a number {} columns wide was expected", shown(text), width));
    ++at_;
    return *value;
  }
  void end_of_string() { at_ = 0; }

 private:
  std::string_view rest_, values_;
  const std::filesystem::path& name_;
  std::size_t number_ = 0;
  std::optional<Index> pending_;
  FortranFormat format_;
  int at_ = 0;
};

// Behind the name.
std::optional<FortranFormat> values_format(std::string_view header) {
  std::string_view written = header.size() > 40 ? header.substr(40) : std::string_view("1P,5E16.9");
  while (!written.empty() && (written.back() == ' ' || written.back() == '\r')) written.remove_suffix(1);
  return fortran_format(fmt::format("({})", written));
}

NamedMatrix read_text_matrix(TextSource& from, const std::filesystem::path& name, std::optional<Index> most) {
  const std::string_view first = from.line("the header of a matrix");
  const Header h =
      header_of(from.field(first, 0), from.field(first, 1), from.field(first, 3), first.size() > 32 ? first.substr(32, 8) : "", name, 1);
  const auto format = values_format(first);
  if (!format) {
    const std::string_view written = first.substr(40);
    from.fail(fmt::format("the format of values is '{}': one such as 1P,3E23.16 was expected",
                          shown(written.substr(0, written.find_last_not_of(' ') + 1))));
  }
  from.format(*format);
  if (h.complex || beyond(h, most)) {
    from.skip(h);
    return {h.name, {}, {}, unfit(h)};
  }
  Entries entries(name, most);
  entries.require_size(h.rows, h.columns, h.rows * std::min<Index>(h.columns, 1 << 20));
  for (;;) {
    const std::string_view head = from.line("a column, or the column after the last,");
    const Index column = from.field(head, 0), row = from.field(head, 1), words = from.field(head, 2);
    if (column < 1) from.fail(fmt::format("column {} is outside the matrix of {} columns", column, h.columns));
    if (column > h.columns) {
      from.end_of_string();
      if (words > 0) from.value(h.type);  // what closes the matrix
      from.end_of_string();
      break;
    }
    if (row < 0 || words < 0) from.fail(fmt::format("row {} and {} words of column {}", row, words, column));
    from.end_of_string();
    read_column(from, h, column, row, words, entries);
    from.end_of_string();
  }
  return {h.name, entries.dense(h.rows, h.columns, 0), {}};
}

// What a binary file is made of, by the length of its first record.
struct ByteOrder {
  bool swapped = false;  // the other endian
  bool wide = false;     // whole numbers of eight bytes
};

// Fortran records: their length, four bytes, before and behind.
class BinarySource {
 public:
  BinarySource(std::string_view bytes, ByteOrder order, const std::filesystem::path& name) : bytes_(bytes), order_(order), name_(name) {}

  bool over() const { return at_ >= bytes_.size(); }
  [[noreturn]] void fail(const std::string& message) const { io::fail(name_, 0, fmt::format("{} (before byte {})", message, at_)); }
  Index open() {
    const Index length = number<std::int32_t>();
    if (length < 0 || static_cast<std::size_t>(length) > bytes_.size() - at_)
      fail(fmt::format("a record of {} bytes ends beyond the file", length));
    end_ = at_ + static_cast<std::size_t>(length);
    return length;
  }
  void close(Index length) {
    at_ = end_;
    if (number<std::int32_t>() != length) fail("a record does not end as it began");
  }
  Index whole() { return order_.wide ? static_cast<Index>(number<std::int64_t>()) : number<std::int32_t>(); }
  Index values_of(Index words, const Header& h, Index) const { return words / h.words; }
  bool wide() const { return order_.wide; }
  double value(int type) {
    const double v = type == 2 || order_.wide ? number<double>() : static_cast<double>(number<float>());
    if (!std::isfinite(v)) fail("a value is not finite");
    return v;
  }
  void end_of_string() {}
  std::string_view text(std::size_t length) {
    require(length);
    const std::string_view t = bytes_.substr(at_, length);
    at_ += length;
    return t;
  }

 private:
  void require(std::size_t length) const {
    if (length > bytes_.size() - at_) fail("the file ends within a number");
  }
  template <class T>
  T number() {
    require(sizeof(T));
    char b[sizeof(T)];
    std::memcpy(b, bytes_.data() + at_, sizeof(T));
    if (order_.swapped) {
      for (std::size_t k = 0; k < sizeof(T) / 2; ++k) std::swap(b[k], b[sizeof(T) - 1 - k]);
    }
    at_ += sizeof(T);
    T v;
    std::memcpy(&v, b, sizeof(T));
    return v;
  }

  std::string_view bytes_;
  ByteOrder order_;
  const std::filesystem::path& name_;
  std::size_t at_ = 0, end_ = 0;
};

NamedMatrix read_binary_matrix(BinarySource& from, const std::filesystem::path& name, std::optional<Index> most) {
  const Index length = from.open();
  const Index expected = from.wide() ? 48 : 24;
  if (length != expected) from.fail(fmt::format("a header of {} bytes: {} were expected", length, expected));
  const Index columns = from.whole(), rows = from.whole();
  from.whole();  // the form
  const Index type = from.whole();
  Header h = header_of(columns, rows, type, from.text(from.wide() ? 16 : 8), name, 0);
  if (from.wide()) h.words = 1;
  from.close(length);
  Entries entries(name, most);
  const bool passed_over = h.complex || beyond(h, most);
  if (!passed_over) entries.require_size(h.rows, h.columns, h.rows * std::min<Index>(h.columns, 1 << 20));
  for (;;) {
    const Index record = from.open();
    const Index column = from.whole(), row = from.whole(), words = from.whole();
    if (column < 1 || row < 0 || words < 0) from.fail(fmt::format("column {}, row {}, {} words", column, row, words));
    if (column <= h.columns && !passed_over) read_column(from, h, column, row, words, entries);
    from.close(record);
    if (column > h.columns) break;
  }
  if (passed_over) return {h.name, {}, {}, unfit(h)};
  return {h.name, entries.dense(h.rows, h.columns, 0), {}};
}

// By a first record of 24 bytes, or 48 with wide numbers; nothing where it has another length.
std::optional<ByteOrder> binary_order(std::string_view bytes) {
  if (bytes.size() < 32) return std::nullopt;
  std::uint32_t first = 0;
  std::memcpy(&first, bytes.data(), 4);
  for (const std::uint32_t length : {24U, 48U}) {
    for (const bool swapped : {false, true}) {
      if (first == (swapped ? length << 24 : length)) return ByteOrder{swapped, length == 48};
    }
  }
  return std::nullopt;
}

bool is_text(std::string_view bytes) {
  const std::string_view line = bytes.substr(0, bytes.find('\n'));
  if (line.size() < 33) return false;
  for (std::size_t k = 0; k < 32; ++k) {
    if (!(line[k] == ' ' || line[k] == '-' || (line[k] >= '0' && line[k] <= '9'))) return false;
  }
  return line.substr(0, 8).find_first_of("0123456789") != std::string_view::npos && line[7] != ' ' && line[15] != ' ' && line[23] != ' ' &&
         line[31] != ' ' && (std::isalpha(static_cast<unsigned char>(line[32])) != 0 || (line.size() > 40 && values_format(line)));
}

}  // namespace

bool is_op4(std::string_view bytes) { return binary_order(bytes) || is_text(bytes); }

std::vector<NamedMatrix> parse_op4(std::string_view bytes, const std::filesystem::path& name, std::optional<Index> most) {
  std::vector<NamedMatrix> all;
  if (const auto order = binary_order(bytes)) {
    for (BinarySource from(bytes, *order, name); !from.over();) all.push_back(read_binary_matrix(from, name, most));
  } else {
    for (TextSource from(bytes, name); !from.over();) all.push_back(read_text_matrix(from, name, most));
  }
  return all;
}

}  // namespace gyromode::io
