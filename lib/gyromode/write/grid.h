#pragma once

#include <string>
#include <vector>

namespace gyromode::io {

/// Rows of text cells under a heading, written with aligned columns or as a Markdown table.
class Grid {
 public:
  explicit Grid(std::vector<std::string> heading) : heading_(std::move(heading)) {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  bool empty() const { return rows_.empty(); }

  /// Columns end alike, but for a last one of words; numbers stand with their decimal points above one another. A table
  /// wider than a line has its widest column of words wrapped, or else goes on below, the first column again.
  std::string aligned() const;
  std::string markdown() const;

 private:
  using Row = std::vector<std::string>;

  Grid with_points_aligned() const;
  std::vector<std::size_t> widths() const;
  std::string panel(const std::vector<std::size_t>& columns, const std::vector<std::size_t>& widths) const;

  Row heading_;
  std::vector<Row> rows_;
};

/// Text that Markdown shows as it is.
std::string markdown_escaped(const std::string& text);

}  // namespace gyromode::io
