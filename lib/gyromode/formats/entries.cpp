#include "gyromode/formats/entries.h"

#include "gyromode/base/error.h"
#include "gyromode/base/number.h"
#include "gyromode/formats/matrix_market.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <new>

namespace gyromode::io {

void Entries::fail(std::size_t line, const std::string& message) const { throw Unreadable(file_, line, 0, message); }

void Entries::require_size(Index rows, Index columns, Index entries, std::size_t line) const {
  if (rows < 1 || columns < 1) fail(line, fmt::format("a matrix of {} × {} has no entries: at least 1 × 1 was expected", rows, columns));
  if (most_ && std::max(rows, columns) > *most_)
    throw TooLarge(fmt::format("{}: a matrix of {} × {} is too large: dense models have at most {} coordinates", file_.string(), rows,
                               columns, *most_));
  if (!fits_dense(rows, columns, entries))
    fail(line, fmt::format("a dense {} × {} matrix for {} entries is not made: the size is most probably wrong", rows, columns, entries));
}

Matrix Entries::dense(Index rows, Index columns, int sign) const {
  Matrix a;
  try {
    a = Matrix::Zero(rows, columns);
  } catch (const std::bad_alloc&) {
    fail(0, fmt::format("there is no memory for a dense {} × {} matrix", rows, columns));
  }
  std::vector<Entry> sorted = all_;
  const auto before = [](const Entry& p, const Entry& q) { return p.column != q.column ? p.column < q.column : p.row < q.row; };
  std::sort(sorted.begin(), sorted.end(), before);
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const Entry& e = sorted[k];
    if (k > 0 && !before(sorted[k - 1], e))
      fail(0, fmt::format("entry ({},{}) is given twice: each entry once was expected", e.row + 1, e.column + 1));
    if (sign != 0 && e.row != e.column && a(e.row, e.column) != 0 && a(e.row, e.column) != e.value)
      fail(0, fmt::format("entries ({0},{1}) and ({1},{0}) contradict each other in a matrix that is {2}: {3} and {4}", e.row + 1,
                          e.column + 1, sign > 0 ? "symmetric" : "skew", e.value, sign * a(e.row, e.column)));
    a(e.row, e.column) = e.value;
    if (sign != 0 && e.row != e.column) a(e.column, e.row) = sign * e.value + 0.0;
  }
  return a;
}

std::optional<double> fortran_number(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
  std::string plain;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == 'd' || c == 'D' || c == 'E') {
      plain += 'e';
    } else if ((c == '+' || c == '-') && k > 0 && (std::isdigit(static_cast<unsigned char>(text[k - 1])) || text[k - 1] == '.')) {
      plain += 'e';  // 2.5+10
      plain += c;
    } else {
      plain += c;
    }
  }
  const Parsed p = parse_real(plain);
  return p.outcome == Parsed::ok ? std::optional(p.value) : std::nullopt;
}

std::optional<FortranFormat> fortran_format(std::string_view text) {
  std::string f;
  for (const char c : text) {
    if (c != ' ' && c != '\r') f += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  if (f.size() < 4 || f.front() != '(' || f.back() != ')') return std::nullopt;
  f = f.substr(1, f.size() - 2);
  if (const std::size_t scale = f.find('P'); scale != std::string::npos)
    f = f.substr(scale + 1 + (scale + 1 < f.size() && f[scale + 1] == ','));
  std::size_t at = 0;
  const auto number = [&]() -> int {
    int value = 0;
    while (at < f.size() && std::isdigit(static_cast<unsigned char>(f[at])) && value < 1000) value = 10 * value + (f[at++] - '0');
    return value;
  };
  FortranFormat format{number(), 0};
  if (format.count == 0) format.count = 1;
  if (at >= f.size() || std::string_view("IEDFG").find(f[at]) == std::string_view::npos) return std::nullopt;
  ++at;
  format.width = number();
  if (at < f.size() && f[at] == '.') {
    ++at;
    number();
  }
  if (at < f.size() && f[at] == 'E') {  // E23.16E3
    ++at;
    number();
  }
  if (at != f.size() || format.width < 1 || format.width > 80 || format.count > 200) return std::nullopt;
  return format;
}

}  // namespace gyromode::io
