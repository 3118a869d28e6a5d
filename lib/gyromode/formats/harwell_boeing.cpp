// Formats: I. S. Duff, R. G. Grimes, J. G. Lewis, Users' Guide for the Harwell–Boeing Sparse Matrix Collection, 1992;
// the same, The Rutherford–Boeing Sparse Matrix Collection, RAL-TR-97-031, 1997.
#include "gyromode/formats/harwell_boeing.h"

#include "gyromode/base/number.h"
#include "gyromode/formats/entries.h"
#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace gyromode::io {

namespace {

// Lines as they stand, blanks and all: columns mean something.
class Cards {
 public:
  Cards(std::string_view text, const std::filesystem::path& name) : rest_(text), name_(name) {}

  std::string_view next(std::string_view what) {
    if (rest_.empty()) throw Unreadable(name_, number_, 0, fmt::format("the file ends where {} was expected", what));
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++number_;
    return line;
  }
  bool over() const { return rest_.empty(); }
  std::size_t number() const { return number_; }
  [[noreturn]] void fail(const std::string& message) const { throw Unreadable(name_, number_, 0, message); }

 private:
  std::string_view rest_;
  const std::filesystem::path& name_;
  std::size_t number_ = 0;
};

std::string_view columns(std::string_view line, std::size_t first, std::size_t width) {
  return first >= line.size() ? std::string_view() : line.substr(first, width);
}

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
  while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
  return s;
}

std::string type_of(std::string_view third_line) {
  std::string type;
  for (const char c : columns(third_line, 0, 3)) type += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return type;
}

// The fields of a line by their columns.
std::vector<std::string_view> by_columns(std::string_view line, const FortranFormat& format, std::size_t count) {
  std::vector<std::string_view> fields;
  for (std::size_t k = 0; k < count; ++k)
    fields.push_back(columns(line, k * static_cast<std::size_t>(format.width), static_cast<std::size_t>(format.width)));
  return fields;
}

std::vector<std::string_view> by_blanks(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t at = 0; (at = line.find_first_not_of(' ', at)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find(' ', at), line.size());
    fields.push_back(line.substr(at, end - at));
    at = end;
  }
  return fields;
}

bool all_numbers(const std::vector<std::string_view>& fields) {
  return std::all_of(fields.begin(), fields.end(), [](std::string_view f) { return fortran_number(f).has_value(); });
}

// `count` numbers of a Fortran format. scipy writes fields one column narrower than the format that it gives: where the
// columns hold no numbers, and the words of the line are as many as there must be, those are read.
template <class Take>
void read_numbers(Cards& cards, Index count, const FortranFormat& format, std::string_view what, Take&& take) {
  for (Index k = 0; k < count;) {
    const std::string_view line = cards.next(fmt::format("{} {} of {}", what, k + 1, count));
    const auto here = static_cast<std::size_t>(std::min<Index>(format.count, count - k));
    std::vector<std::string_view> fields = by_columns(line, format, here);
    if (!all_numbers(fields)) {
      const std::vector<std::string_view> words = by_blanks(line);
      if (words.size() == here && all_numbers(words)) fields = words;
    }
    for (const std::string_view text : fields) {
      const auto value = fortran_number(text);
      if (!value) cards.fail(fmt::format("{} {} is '{}': a number {} columns wide was expected", what, k + 1, shown(text), format.width));
      take(k++, *value);
    }
  }
}

FortranFormat format_of(Cards& cards, std::string_view text, std::string_view what) {
  const auto format = fortran_format(trimmed(text));
  if (!format) cards.fail(fmt::format("the format of {} is '{}': one such as (16I5) or (5E16.8) was expected", what, shown(trimmed(text))));
  return *format;
}

Index whole(Cards& cards, std::string_view text, std::string_view what) {
  const auto value = whole_number(trimmed(text));
  if (!value || *value < 0) cards.fail(fmt::format("{} is '{}': a whole number was expected", what, shown(text)));
  return *value;
}

int symmetry_of(Cards& cards, const std::string& type) {
  if (type[0] == 'C') cards.fail("the matrix is complex: a real one was expected");
  if (type[0] == 'P' || type[0] == 'Q') cards.fail("the file holds the pattern of a matrix, and no values: a real matrix was expected");
  if (type[2] != 'A') cards.fail("the matrix is given by elements: an assembled one was expected");
  return type[1] == 'S' ? 1 : type[1] == 'Z' ? -1 : 0;
}

}  // namespace

bool is_harwell_boeing(std::string_view text) {
  for (int line = 0; line < 2; ++line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return false;
    text.remove_prefix(end + 1);
  }
  const std::string type = type_of(text);
  return type.size() == 3 && std::string_view("RCPIQ").find(type[0]) != std::string_view::npos &&
         std::string_view("SUHZR").find(type[1]) != std::string_view::npos && (type[2] == 'A' || type[2] == 'E') &&
         columns(text, 3, 11).find_first_not_of(' ') == std::string_view::npos;
}

NamedMatrix parse_harwell_boeing(std::string_view text, const std::filesystem::path& name, std::optional<Index> most) {
  Cards cards(text, name);
  const std::string_view title = cards.next("the title");
  const std::string_view counts = cards.next("the numbers of lines");
  const std::string_view sizes = cards.next("type and sizes");
  const std::string type = type_of(sizes);
  const int sign = symmetry_of(cards, type);
  const Index rows = whole(cards, columns(sizes, 14, 14), "the number of rows"),
              order = whole(cards, columns(sizes, 28, 14), "the number of columns");
  const Index count = whole(cards, columns(sizes, 42, 14), "the number of entries");
  Entries entries(name, most);
  entries.require_size(rows, order, count, cards.number());
  if (sign != 0 && rows != order) cards.fail(fmt::format("a symmetric matrix must be square: this one is {} × {}", rows, order));
  const std::string_view formats = cards.next("the formats");
  const FortranFormat of_pointers = format_of(cards, columns(formats, 0, 16), "pointers");
  const FortranFormat of_indices = format_of(cards, columns(formats, 16, 16), "row indices");
  const FortranFormat of_values = format_of(cards, columns(formats, 32, 20), "values");
  const std::string_view right_sides = trimmed(columns(counts, 56, 14));
  if (!right_sides.empty() && whole(cards, right_sides, "the number of lines of right-hand sides") > 0)
    cards.next("the types of right-hand sides");

  std::vector<Index> pointers, places;
  const auto into = [&](std::vector<Index>& to, Index least, Index largest, std::string_view what) {
    return [&to, least, largest, what, &cards](Index, double value) {
      if (!(value >= static_cast<double>(least) && value <= static_cast<double>(largest)) ||
          value != static_cast<double>(static_cast<Index>(value)))
        cards.fail(fmt::format("{} {} is outside the matrix: a whole number from {} to {} was expected", what, value, least, largest));
      to.push_back(static_cast<Index>(value));
    };
  };
  read_numbers(cards, order + 1, of_pointers, "pointer", into(pointers, 1, count + 1, "pointer"));
  if (!std::is_sorted(pointers.begin(), pointers.end()) || pointers.back() != count + 1)
    cards.fail(fmt::format("the pointers do not ascend to {}, the number of entries and one", count + 1));
  read_numbers(cards, count, of_indices, "row index", into(places, 1, rows, "row index"));
  Index column = 0;
  read_numbers(cards, count, of_values, "value", [&](Index k, double value) {
    while (column < order && pointers[static_cast<std::size_t>(column) + 1] <= k + 1) ++column;
    entries.add(places[static_cast<std::size_t>(k)] - 1, column, value);
  });
  const std::string_view key = trimmed(columns(title, 72, 8));
  return {key.empty() ? name.stem().string() : std::string(key), entries.dense(rows, order, sign), {}};
}

}  // namespace gyromode::io
