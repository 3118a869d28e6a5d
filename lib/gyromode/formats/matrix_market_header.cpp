#include "gyromode/formats/matrix_market_header.h"

#include "gyromode/base/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace gyromode::io {

namespace {

constexpr Index largest_side = std::numeric_limits<std::int32_t>::max();  // rows · cols then fits an Index

std::string lower_case(std::string_view word) {
  std::string out(word);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

std::string_view reason_to_refuse(std::string_view word) {
  if (word == "complex" || word == "hermitian") return " (only real matrices are)";
  if (word == "pattern") return " (it has no values)";
  return "";
}

// The place of `word` among those this reader knows.
std::size_t choice(const Lines& lines, std::string_view what, std::string_view word, std::initializer_list<std::string_view> known) {
  const std::string lower = lower_case(word);
  const auto found = std::find(known.begin(), known.end(), lower);
  if (found == known.end()) {
    lines.fail(fmt::format("{} '{}' is not read{}: {} was expected", what, shown(word), reason_to_refuse(lower), fmt::join(known, " or ")));
  }
  return static_cast<std::size_t>(found - known.begin());
}

Index read_size_number(const Lines& lines, std::string_view what, std::string_view word, Index least, Index most) {
  const auto value = whole_number(word);
  if (!value || *value < least || *value > most) {
    lines.fail(fmt::format("{} '{}': a whole number from {} to {} was expected", what, shown(word), least, most));
  }
  return *value;
}

// Values that an array file stores.
Index array_length(Index rows, Index cols, Symmetry symmetry) {
  if (symmetry == Symmetry::symmetric) return rows * (rows + 1) / 2;
  if (symmetry == Symmetry::skew_symmetric) return rows * (rows - 1) / 2;
  return rows * cols;
}

}  // namespace

Banner read_banner(Lines& lines) {
  lines.next();
  lines.split();
  const auto words = lines.words();
  if (words.size() != 5 || lower_case(words[0]) != "%%matrixmarket") {
    lines.fail(fmt::format("first line '{}' is not a banner: '{}' was expected", shown(lines.line()), banner_form));
  }
  choice(lines, "object", words[1], {"matrix"});
  constexpr std::array symmetries = {Symmetry::general, Symmetry::symmetric, Symmetry::skew_symmetric};
  return {.coordinate = choice(lines, "format", words[2], {"coordinate", "array"}) == 0,
          .integer = choice(lines, "field", words[3], {"real", "integer"}) == 1,
          .symmetry = symmetries[choice(lines, "symmetry", words[4], {"general", "symmetric", "skew-symmetric"})]};
}

Size read_size(Lines& lines, const Banner& banner) {
  const std::string_view form = banner.coordinate ? "the size line 'rows columns entries'" : "the size line 'rows columns'";
  if (!lines.next_data()) lines.fail(fmt::format("the file ends here: {} was expected", form));
  const auto words = lines.words(banner.coordinate ? 3 : 2, form);
  Size size{.line = lines.number()};
  size.rows = read_size_number(lines, "number of rows", words[0], 1, largest_side);
  size.cols = read_size_number(lines, "number of columns", words[1], 1, largest_side);
  if (banner.symmetry != Symmetry::general && size.rows != size.cols) {
    lines.fail(fmt::format("size {} x {} is not square: the first line promises symmetry", size.rows, size.cols));
  }
  if (!banner.coordinate) {
    size.entries = array_length(size.rows, size.cols, banner.symmetry);
    return size;
  }
  size.entries = read_size_number(lines, "number of entries", words[2], 0, std::numeric_limits<Index>::max());
  if (!fits_dense(size.rows, size.cols, size.entries)) {
    lines.fail(
        fmt::format("size {} x {} with {} entries is not read as a dense matrix of {:.3g} GB: at most 0.268 GB, or sides up to "
                    "46000 and an entry for each row or column was expected",
                    size.rows, size.cols, size.entries, 8e-9 * static_cast<double>(size.rows) * static_cast<double>(size.cols)));
  }
  return size;
}

}  // namespace gyromode::io

namespace gyromode {

bool fits_dense(Index rows, Index cols, Index entries) {
  constexpr Index always = (Index{256} << 20) / Index{sizeof(double)};
  constexpr Index longest = 46'000;  // about where LAPACK's 32-bit indices end: 46 340² = 2³¹
  if (rows <= always && cols <= always / std::max(rows, Index{1})) return true;
  return std::max(rows, cols) <= longest && entries >= std::min(rows, cols);
}

}  // namespace gyromode
