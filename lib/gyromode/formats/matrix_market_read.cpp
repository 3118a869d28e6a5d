// Format: R. F. Boisvert, R. Pozo, K. A. Remington, The Matrix Market Exchange Formats: Initial Design, NISTIR 5935,
// 1996.
#include "gyromode/formats/matrix_market.h"

#include "gyromode/base/error.h"
#include "gyromode/formats/matrix_market_header.h"
#include "gyromode/base/number.h"
#include "gyromode/formats/text_file.h"
#include "gyromode/formats/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <tuple>
#include <vector>

namespace gyromode {

namespace {

using namespace io;

struct Entry {
  Index row = 0;  // counted from 0
  Index col = 0;
  double value = 0;
  std::size_t line = 0;
};

double real_value(const Lines& lines, std::string_view word, std::string_view form) {
  const Parsed number = parse_real(word);
  if (number.outcome == Parsed::not_a_number) lines.fail(fmt::format("value '{}' is not a number: {} was expected", shown(word), form));
  if (number.outcome == Parsed::not_finite) {
    lines.fail(fmt::format("value '{}' is not finite as a double: at most 1.8e308 in magnitude was expected", shown(word)));
  }
  return number.value;
}

double integer_value(const Lines& lines, std::string_view word) {
  constexpr std::int64_t largest = std::int64_t{1} << 53;  // beyond, doubles skip some
  const auto value = whole_number(word);
  if (!value || *value < -largest || *value > largest) {
    lines.fail(fmt::format("value '{}' is not a whole number within 2^53: the first line promises the field integer", shown(word)));
  }
  return static_cast<double>(*value);
}

// Reads the data lines with `read_line()`. Their number is the one promised, or `also`, or this throws; memory grows
// with the text alone.
template <class Item, class ReadLine>
std::vector<Item> read_data(Lines& lines, const Size& size, std::string_view what, ReadLine read_line, Index also = -1) {
  std::vector<Item> items;
  while (lines.next_data()) {
    if (static_cast<Index>(items.size()) == size.entries) {
      lines.fail(fmt::format("'{}' is one too many: line {} promises {}", shown(lines.line()), size.line, size.entries));
    }
    items.push_back(read_line());
  }
  if (static_cast<Index>(items.size()) < size.entries && static_cast<Index>(items.size()) != also) {
    if (also >= 0 && static_cast<Index>(items.size()) > also)
      lines.fail(fmt::format("{} values: line {} promises {}, or {} with the zero diagonal", items.size(), size.line, also, size.entries));
    const Index promised = also >= 0 ? also : size.entries;
    lines.fail(fmt::format("the file ends after {} of the {} {} that line {} promises", items.size(), promised, what, size.line));
  }
  return items;
}

double read_value(const Lines& lines, const Banner& banner, std::string_view word, std::string_view form) {
  return banner.integer ? integer_value(lines, word) : real_value(lines, word, form);
}

Index read_index(const Lines& lines, std::string_view what, std::string_view word, Index count) {
  const auto value = whole_number(word);
  if (!value || *value < 1 || *value > count) {
    lines.fail(fmt::format("{} '{}' is outside the matrix: a whole number from 1 to {} was expected", what, shown(word), count));
  }
  return *value - 1;
}

Entry read_entry(const Lines& lines, const Banner& banner, const Size& size) {
  constexpr std::string_view form = "'row column value'";
  const auto words = lines.words(3, form);
  const Entry entry{.row = read_index(lines, "row", words[0], size.rows),
                    .col = read_index(lines, "column", words[1], size.cols),
                    .value = read_value(lines, banner, words[2], form),
                    .line = lines.number()};
  if (banner.symmetry != Symmetry::general && entry.row < entry.col) {
    lines.fail(fmt::format("entry ({},{}) is above the diagonal: with symmetry only the lower triangle was expected", entry.row + 1,
                           entry.col + 1));
  }
  if (banner.symmetry == Symmetry::skew_symmetric && entry.row == entry.col && entry.value != 0) {
    lines.fail(fmt::format("entry ({0},{0}) = {1} is on the diagonal of a skew-symmetric matrix: zero or no entry was expected",
                           entry.row + 1, shown(words[2])));
  }
  return entry;
}

// Sorts the entries by place, and refuses the earliest repetition in the file.
void require_distinct(std::vector<Entry>& entries, const std::filesystem::path& name) {
  const auto key = [](const Entry& e) { return std::tuple(e.col, e.row, e.line); };
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) { return key(a) < key(b); });
  const Entry* repeated = nullptr;
  for (std::size_t k = 1; k < entries.size(); ++k) {
    const bool same = entries[k].col == entries[k - 1].col && entries[k].row == entries[k - 1].row;
    if (same && (!repeated || entries[k].line < repeated->line)) repeated = &entries[k];
  }
  if (!repeated) return;
  throw Unreadable(name, repeated->line, 0,
                   fmt::format("entry ({},{}) was already given in line {}: each entry once was expected", repeated->row + 1,
                               repeated->col + 1, (repeated - 1)->line));
}

Matrix zero_matrix(const Size& size, const std::filesystem::path& name) {
  try {
    return Matrix::Zero(size.rows, size.cols);
  } catch (const std::bad_alloc&) {
    throw Unreadable(name, size.line, 0, fmt::format("there is no memory for a dense {} x {} matrix", size.rows, size.cols));
  }
}

void place(Matrix& a, Index row, Index col, double value, Symmetry symmetry) {
  if (symmetry == Symmetry::symmetric) a(col, row) = value;
  if (symmetry == Symmetry::skew_symmetric) a(col, row) = 0.0 - value;  // not −value: that makes −0 of 0
  a(row, col) = value;
}

Matrix read_coordinate(Lines& lines, const Banner& banner, const Size& size, const std::filesystem::path& name) {
  auto entries = read_data<Entry>(lines, size, "entries", [&] { return read_entry(lines, banner, size); });
  require_distinct(entries, name);
  Matrix a = zero_matrix(size, name);
  for (const Entry& e : entries) place(a, e.row, e.col, e.value, banner.symmetry);
  return a;
}

// Column by column; with symmetry each column starts at, or for skew-symmetric below, the diagonal. MATLAB and older
// scipy write the zero diagonal of skew-symmetric ones, too.
Matrix read_array(Lines& lines, const Banner& banner, const Size& size, const std::filesystem::path& name) {
  constexpr std::string_view form = "one value a line";
  const auto read_line = [&] { return read_value(lines, banner, lines.words(1, form)[0], form); };
  Size to_read = size;
  const bool skew = banner.symmetry == Symmetry::skew_symmetric;
  if (skew) to_read.entries += size.rows;
  const auto values = read_data<double>(lines, to_read, "values", read_line, skew ? size.entries : to_read.entries);
  const bool with_diagonal = skew && static_cast<Index>(values.size()) > size.entries;
  Matrix a = zero_matrix(size, name);
  auto value = values.begin();
  for (Index col = 0; col < size.cols; ++col) {
    if (with_diagonal && *value++ != 0)
      lines.fail(
          fmt::format("entry ({0},{0}) = {1} is on the diagonal of a skew-symmetric matrix: zero was expected", col + 1, *(value - 1)));
    const Index first = banner.symmetry == Symmetry::general ? 0 : banner.symmetry == Symmetry::symmetric ? col : col + 1;
    for (Index row = first; row < size.rows; ++row) place(a, row, col, *value++, banner.symmetry);
  }
  return a;
}

}  // namespace

Matrix parse_matrix_market(std::string_view text, const std::filesystem::path& name, std::optional<Index> most) {
  if (text.empty()) throw Unreadable(name, fmt::format("is empty: '{}' was expected as its first line", banner_form));
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    const auto line = static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(nul), '\n')) + 1;
    throw Unreadable(name, line, 0, "byte '\\x00' is not text: this is a binary file, a Matrix Market file was expected");
  }
  Lines lines(text, name);
  const Banner banner = read_banner(lines);
  const Size size = read_size(lines, banner);
  if (most && size.rows > *most) {
    lines.fail(fmt::format("size {} x {} is too large: dense models have at most {} coordinates", size.rows, size.cols, *most));
  }
  return banner.coordinate ? read_coordinate(lines, banner, size, name) : read_array(lines, banner, size, name);
}

Matrix read_matrix_market(const std::filesystem::path& file) { return parse_matrix_market(read_text(file, "Matrix Market"), file); }

}  // namespace gyromode
