#pragma once

#include <string>
#include <vector>

namespace gyromode::io {

/// Rows of text cells under a heading, written with aligned columns or as a Markdown table. UTF-8 counts by code
/// points.
class Grid {
 public:
  explicit Grid(std::vector<std::string> heading) : heading_(std::move(heading)) {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  bool empty() const { return rows_.empty(); }

  std::string aligned() const;  ///< columns right-aligned but for the last
  std::string markdown() const;

 private:
  std::vector<std::string> heading_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace gyromode::io
