// Format: CalculiX CrunchiX user's manual, *FREQUENCY, SOLVER=MATRIXSTORAGE; Matrix Market exchange formats (Boisvert,
// Pozo and Remington 1996).
#include "gyromode/formats/triplet_file.h"

#include "gyromode/base/error.h"
#include "gyromode/base/number.h"
#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
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

// After the banner, where there is one: the order that its size line gives; 0 of a file without.
Index order_of_header(LinesOfFile& lines, std::string_view& line) {
  if (!line.starts_with('%')) return 0;
  if (line.find("coordinate") == std::string_view::npos || line.find("symmetric") == std::string_view::npos ||
      line.find("skew") != std::string_view::npos)
    lines.fail("the banner of a symmetric matrix of coordinates was expected: %%MatrixMarket matrix coordinate real symmetric");
  while (line.starts_with('%') || is_blank(line)) {
    if (!lines.next(line)) lines.fail("the file ends where its size was expected: rows columns entries");
  }
  Entry size;
  if (!entry_of(line, size) || size.row != size.column || size.row < 1)
    lines.fail(fmt::format("'{}' where the size of a square matrix was expected: rows columns entries", shown(line)));
  return static_cast<Index>(size.row);
}

}  // namespace

SparseMatrix read_symmetric_triplets(const std::filesystem::path& file, Index order) {
  constexpr std::int64_t most = std::numeric_limits<int>::max() - 1;
  LinesOfFile lines(file);
  std::string_view line;
  if (!lines.next(line)) throw Unreadable(file, "is empty: lines 'row column value' were expected");
  const Index given = order_of_header(lines, line);
  if (given > 0 && order > 0 && given != order)
    lines.fail(fmt::format("a matrix of order {}: {} was expected, one a line of the dof table", given, order));
  bool more = given == 0 || lines.next(line);
  std::vector<Eigen::Triplet<double>> entries;
  std::int64_t largest = given > 0 ? given : order;
  for (; more; more = lines.next(line)) {
    if (is_blank(line)) continue;
    Entry e;
    if (!entry_of(line, e))
      lines.fail(fmt::format("'{}' is no entry: row, column and a finite number were expected, in full", shown(line)));
    if (e.row < 1 || e.column < 1 || e.row > most || e.column > most ||
        (largest > 0 && (given > 0 || order > 0) && (e.row > largest || e.column > largest)))
      lines.fail(fmt::format("entry ({}, {}) is outside a matrix of order {}{}", e.row, e.column, largest,
                             order > 0 ? ", which the dof table gives: is the file of another model?" : ""));
    if (!std::isfinite(e.value)) lines.fail(fmt::format("entry ({}, {}) is not finite", e.row, e.column));
    if (given == 0 && order == 0) largest = std::max({largest, e.row, e.column});
    entries.emplace_back(static_cast<int>(std::max(e.row, e.column)) - 1, static_cast<int>(std::min(e.row, e.column)) - 1, e.value);
  }
  if (entries.empty()) throw Unreadable(file, "has no entries: lines 'row column value' were expected");
  SparseMatrix a(largest, largest);
  a.setFromTriplets(entries.begin(), entries.end());
  if (a.nonZeros() != static_cast<Index>(entries.size()))
    throw Unreadable(file, "gives an entry twice, or both triangles: one triangle of the matrix was expected");
  return a;
}

}  // namespace gyromode::io
