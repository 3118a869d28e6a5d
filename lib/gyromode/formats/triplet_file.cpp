// Format: CalculiX CrunchiX user's manual, *FREQUENCY, SOLVER=MATRIXSTORAGE; Matrix Market exchange formats (Boisvert,
// Pozo and Remington 1996).
#include "gyromode/formats/triplet_file.h"

#include "gyromode/base/error.h"
#include "gyromode/base/number.h"
#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace gyromode::io {

namespace {

// The lines of a file, one after the other, from a window of it.
class LinesOfFile {
 public:
  explicit LinesOfFile(const std::filesystem::path& file) : path_(file), file_(std::fopen(file.c_str(), "rb"), &std::fclose) {
    if (!file_) throw Unreadable(file, "cannot be opened: a file of matrix entries was expected");
  }
  // The next line; false at the end. The last need not end.
  bool next(std::string_view& line) {
    while (true) {
      const std::size_t end = buffer_.find('\n', at_);
      if (end != std::string::npos) {
        line = std::string_view(buffer_).substr(at_, end - at_);
        at_ = end + 1;
        ++number_;
        return true;
      }
      if (!fill()) break;
    }
    if (at_ >= buffer_.size()) return false;
    line = std::string_view(buffer_).substr(at_);
    at_ = buffer_.size();
    ++number_;
    return true;
  }
  std::size_t number() const { return number_; }
  [[noreturn]] void fail(const std::string& what) const { throw Unreadable(path_, number_, 0, what); }

 private:
  bool fill() {
    constexpr std::size_t piece = std::size_t{1} << 22;
    buffer_.erase(0, at_);
    at_ = 0;
    const std::size_t before = buffer_.size();
    buffer_.resize(before + piece);
    const std::size_t got = std::fread(buffer_.data() + before, 1, piece, file_.get());
    buffer_.resize(before + got);
    return got > 0;
  }

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::string buffer_;
  std::size_t at_ = 0, number_ = 0;
};

struct Entry {
  std::int64_t row = 0, column = 0;
  double value = 0;
};

const char* past_blanks(const char* p, const char* end) {
  while (p < end && (*p == ' ' || *p == '\t' || *p == '\r')) ++p;
  return p;
}

// "row column value"; false where the line is something else.
bool entry_of(std::string_view line, Entry& e) {
  const char *p = line.data(), *end = p + line.size();
  p = past_blanks(p, end);
  auto r = std::from_chars(p, end, e.row);
  if (r.ec != std::errc()) return false;
  p = past_blanks(r.ptr, end);
  r = std::from_chars(p, end, e.column);
  if (r.ec != std::errc() || r.ptr == p) return false;
  p = past_blanks(r.ptr, end);
  const auto v = std::from_chars(p, end, e.value);
  if (v.ec == std::errc() && past_blanks(v.ptr, end) == end) return true;
  const Parsed slow = parse_real(std::string_view(p, static_cast<std::size_t>(end - p)));  // 1.0D+05
  e.value = slow.value;
  return slow.outcome == Parsed::ok;
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

// What the size line after a banner gives; zeros of a file without.
struct Header {
  Index order = 0, entries = 0;
  std::size_t line = 0;
};

Header header_of(LinesOfFile& lines, std::string_view& line, int sign) {
  if (!line.starts_with('%')) return {};
  const auto says = [&](std::string_view word) { return line.find(word) != std::string_view::npos; };
  const bool skew = says("skew"), fits = says("general") || (sign > 0 ? says("symmetric") && !skew : skew);
  if (!says("coordinate") || says("complex") || !fits)
    lines.fail(fmt::format("the banner of a {} matrix of coordinates was expected: %%MatrixMarket matrix coordinate real {}",
                           sign > 0 ? "symmetric" : "skew", sign > 0 ? "symmetric" : "skew-symmetric"));
  while (line.starts_with('%') || is_blank(line)) {
    if (!lines.next(line)) lines.fail("the file ends where its size was expected: rows columns entries");
  }
  Entry size;
  if (!entry_of(line, size) || size.row != size.column || size.row < 1)
    lines.fail(fmt::format("'{}' where the size of a square matrix was expected: rows columns entries", shown(line)));
  return {static_cast<Index>(size.row), static_cast<Index>(size.value), lines.number()};
}

using Triplets = std::vector<Eigen::Triplet<double>>;

// Rows of a column ascending, with their values.
void sort_column(int* rows, double* values, Index count, const std::filesystem::path& file) {
  if (!std::is_sorted(rows, rows + count)) {
    std::vector<std::pair<int, double>> column;
    for (Index k = 0; k < count; ++k) column.emplace_back(rows[k], values[k]);
    std::sort(column.begin(), column.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (Index k = 0; k < count; ++k) std::tie(rows[k], values[k]) = column[static_cast<std::size_t>(k)];
  }
  if (std::adjacent_find(rows, rows + count) != rows + count) throw Unreadable(file, "gives an entry twice: each entry once was expected");
}

// By counting, each entry once to its place: files that are in some order need no sorting.
SparseMatrix distinct(Triplets entries, Index order, const std::filesystem::path& file) {
  SparseMatrix a(order, order);
  a.resizeNonZeros(static_cast<Index>(entries.size()));
  int* first = a.outerIndexPtr();
  for (const auto& e : entries) ++first[e.col() + 1];
  std::partial_sum(first, first + order + 1, first);
  std::vector<int> next(first, first + order);
  for (const auto& e : entries) {
    const int at = next[static_cast<std::size_t>(e.col())]++;
    a.innerIndexPtr()[at] = e.row();
    a.valuePtr()[at] = e.value();
  }
  Triplets().swap(entries);
  for (Index j = 0; j < order; ++j) sort_column(a.innerIndexPtr() + first[j], a.valuePtr() + first[j], first[j + 1] - first[j], file);
  return a;
}

// Half of what both triangles give, where they agree.
SparseMatrix mean_of(const SparseMatrix& lower, const SparseMatrix& mirrored, const std::filesystem::path& file, int sign) {
  constexpr double rounding = 1e-9;
  const SparseMatrix off = lower - mirrored;
  for (Index j = 0; j < off.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(off, j); it; ++it) {
      const double one = lower.coeff(it.row(), j), other = mirrored.coeff(it.row(), j);
      if (std::abs(it.value()) <= rounding * std::max(std::abs(one), std::abs(other))) continue;
      throw LawBroken(fmt::format("{0}: entry ({1}, {2}) is {3} and entry ({2}, {1}) is {4}: a {5} matrix was expected", file.string(),
                                  it.row() + 1, j + 1, one, sign * other, sign > 0 ? "symmetric" : "skew"));
    }
  }
  return 0.5 * (lower + mirrored);
}

}  // namespace

SparseMatrix read_triplets(const std::filesystem::path& file, Index order, int sign) {
  constexpr std::int64_t most = std::numeric_limits<int>::max() - 1;
  LinesOfFile lines(file);
  std::string_view line;
  if (!lines.next(line)) throw Unreadable(file, "is empty: lines 'row column value' were expected");
  const Header header = header_of(lines, line, sign);
  const Index given = header.order;
  if (given > 0 && order > 0 && given != order)
    lines.fail(fmt::format("a matrix of order {}: {} was expected, as the model has coordinates", given, order));
  bool more = given == 0 || lines.next(line);
  Triplets lower, mirrored;  // of the upper triangle
  // Address space for as many as the file can have: vectors that grow would be copied again and again.
  constexpr std::uintmax_t least_line = 8, usual_line = 24;
  std::error_code unknown;  // of a pipe, say: nothing is set aside
  const std::uintmax_t size = std::filesystem::file_size(file, unknown), bytes = unknown ? 0 : size;
  const std::size_t room = static_cast<std::size_t>(bytes / (bytes > (1U << 20) ? usual_line : least_line)) + 1;
  std::int64_t largest = given > 0 ? given : order;
  Index count = 0;
  for (; more; more = lines.next(line)) {
    if (is_blank(line) || (given > 0 && line.starts_with('%'))) continue;
    if (given > 0 && ++count > header.entries)
      lines.fail(fmt::format("one entry more than the {} that line {} promises", header.entries, header.line));
    Entry e;
    if (!entry_of(line, e))
      lines.fail(fmt::format("'{}' is no entry: row, column and a finite number were expected, in full", shown(line)));
    if (e.row < 1 || e.column < 1 || e.row > most || e.column > most ||
        (largest > 0 && (given > 0 || order > 0) && (e.row > largest || e.column > largest)))
      lines.fail(fmt::format("entry ({}, {}) is outside a matrix of order {}{}", e.row, e.column, largest,
                             order > 0 ? ", which the others give: is the file of another model?" : ""));
    if (!std::isfinite(e.value)) lines.fail(fmt::format("entry ({}, {}) is not finite", e.row, e.column));
    if (given == 0 && order == 0) largest = std::max({largest, e.row, e.column});
    if (sign < 0 && e.row == e.column) {
      if (e.value != 0)
        lines.fail(fmt::format("entry ({0}, {0}) = {1} is on the diagonal of a skew matrix: zero was expected", e.row, e.value));
      continue;
    }
    const int row = static_cast<int>(e.row) - 1, column = static_cast<int>(e.column) - 1;
    Triplets& to = row >= column ? lower : mirrored;
    if (row != column && to.capacity() < room) to.reserve(room);
    to.emplace_back(std::max(row, column), std::min(row, column), row >= column ? e.value : sign * e.value);
  }
  if (count < header.entries)
    lines.fail(fmt::format("the file ends after {} of the {} entries that line {} promises", count, header.entries, header.line));
  if (lower.empty() && mirrored.empty() && (sign > 0 || given == 0))
    throw Unreadable(file, "has no entries: lines 'row column value' were expected");
  const bool off_diagonal = std::any_of(lower.begin(), lower.end(), [](const auto& e) { return e.row() != e.col(); });
  if (off_diagonal && !mirrored.empty()) {
    SparseMatrix both = distinct(std::move(lower), largest, file), other = distinct(std::move(mirrored), largest, file);
    const Vector diagonal = both.diagonal();
    for (Index k = 0; k < largest; ++k) {
      if (diagonal(k) != 0) other.coeffRef(k, k) = diagonal(k);
    }
    return mean_of(both, other, file, sign);
  }
  if (lower.size() < mirrored.size()) lower.swap(mirrored);
  lower.insert(lower.end(), mirrored.begin(), mirrored.end());
  Triplets().swap(mirrored);
  return distinct(std::move(lower), largest, file);
}

std::optional<Index> order_of_large(const std::filesystem::path& file) {
  constexpr double most_dense = 5000, filled = 0.05;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  LinesOfFile lines(file);
  std::string_view line;
  if (!lines.next(line) || !line.starts_with("%%MatrixMarket matrix coordinate")) return std::nullopt;
  while (line.starts_with('%') || is_blank(line)) {
    if (!lines.next(line)) return std::nullopt;
  }
  Entry size;  // rows, columns, entries
  if (!entry_of(line, size) || size.row != size.column) return std::nullopt;
  const auto n = static_cast<double>(size.row);
  return n > most_dense && size.value < filled * n * n ? std::optional<Index>(size.row) : std::nullopt;
}

}  // namespace gyromode::io
