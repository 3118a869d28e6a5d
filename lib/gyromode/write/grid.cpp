#include "gyromode/write/grid.h"

#include "gyromode/base/lines.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <string_view>

namespace gyromode::io {

namespace {

constexpr std::size_t column_gap = 2;    // before every column
constexpr std::size_t least_words = 20;  // of a column that is wrapped

std::string blanks(std::size_t n) { return std::string(n, ' '); }

// Complex ones, too: their real parts are aligned, or imaginary parts that stand alone.
bool is_number(std::string_view cell) {
  cell = cell.substr(0, cell.find_last_not_of(' ') + 1);
  if (cell.starts_with("≈")) cell.remove_prefix(std::string_view("≈").size());
  return !cell.empty() && cell.find_first_not_of("0123456789.+-ej") == std::string_view::npos;
}

bool has_words(const std::vector<std::vector<std::string>>& rows, std::size_t column) {
  return std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return !row[column].empty() && !is_number(row[column]); });
}

// What stands before the decimal point, or where it would stand.
std::size_t before_point(std::string_view number) { return columns_of(number.substr(0, number.find_first_of(".ej"))); }

}  // namespace

// Numbers are padded on their right so that the points meet; columns that hold whole numbers alone stay as they are.
Grid Grid::with_points_aligned() const {
  Grid padded = *this;
  for (std::size_t c = 0; c < heading_.size(); ++c) {
    std::size_t after = 0;
    for (const Row& row : rows_) {
      if (is_number(row[c])) after = std::max(after, columns_of(row[c]) - before_point(row[c]));
    }
    for (Row& row : padded.rows_) {
      if (is_number(row[c])) row[c] += blanks(after - (columns_of(row[c]) - before_point(row[c])));
    }
  }
  return padded;
}

std::vector<std::size_t> Grid::widths() const {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < heading_.size(); ++c) {
    widths.push_back(columns_of(heading_[c]));
    for (const Row& row : rows_) widths[c] = std::max(widths[c], columns_of(row[c]));
  }
  return widths;
}

// Cells wider than their column go on in lines below; such columns begin alike, as does a last one of words.
std::string Grid::panel(const std::vector<std::size_t>& columns, const std::vector<std::size_t>& widths) const {
  std::string out;
  const std::vector<std::size_t> natural = this->widths();
  std::vector<bool> left;
  for (std::size_t k = 0; k < columns.size(); ++k)
    left.push_back(natural[columns[k]] > widths[columns[k]] || (k + 1 == columns.size() && has_words(rows_, columns[k])));
  const auto add = [&](const Row& row) {
    std::vector<std::vector<std::string>> cells;
    std::size_t height = 1;
    for (const std::size_t c : columns) {
      const bool fits = columns_of(row[c]) <= widths[c];
      cells.push_back(fits ? std::vector<std::string>{row[c]} : wrapped(row[c], widths[c]));
      height = std::max(height, cells.back().size());
    }
    for (std::size_t l = 0; l < height; ++l) {
      std::string line;
      for (std::size_t k = 0; k < columns.size(); ++k) {
        const std::string cell = l < cells[k].size() ? cells[k][l] : "";
        const std::size_t width = widths[columns[k]], used = std::min(width, columns_of(cell));
        const bool to_the_left = left[k];
        line += blanks(column_gap) + (to_the_left ? cell + blanks(width - used) : blanks(width - used) + cell);
      }
      line.erase(line.find_last_not_of(' ') + 1);
      out += line + "\n";
    }
  };
  add(heading_);
  for (const Row& row : rows_) add(row);
  return out;
}

std::string Grid::aligned() const {
  const Grid padded = with_points_aligned();
  std::vector<std::size_t> widths = padded.widths(), all(heading_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::size_t total = std::accumulate(widths.begin(), widths.end(), column_gap * widths.size());
  if (total <= line_columns) return padded.panel(all, widths);

  const auto widest = static_cast<std::size_t>(std::max_element(widths.begin(), widths.end()) - widths.begin());
  const std::size_t too_much = total - line_columns;
  const bool words = std::any_of(rows_.begin(), rows_.end(), [&](const Row& r) { return r[widest].find(' ') != std::string::npos; });
  if (words && widths[widest] >= too_much + least_words) {
    widths[widest] -= too_much;
    return padded.panel(all, widths);
  }
  std::string out;
  std::size_t next = 1;
  do {
    std::vector<std::size_t> columns{0};
    std::size_t used = column_gap + widths[0];
    while (next < all.size() && (columns.size() == 1 || used + column_gap + widths[next] <= line_columns)) {
      used += column_gap + widths[next];
      columns.push_back(next++);
    }
    out += (out.empty() ? "" : "\n") + padded.panel(columns, widths);
  } while (next < all.size());
  return out;
}

// Escaped is what could begin something: emphasis (an underscore within a word cannot), code, HTML, a link,
// mathematics.
std::string markdown_escaped(const std::string& text) {
  const auto in_word = [&](std::size_t i) {
    const auto letter = [&](std::size_t k) { return k < text.size() && std::isalnum(static_cast<unsigned char>(text[k])); };
    return i > 0 && letter(i - 1) && letter(i + 1);
  };
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool begins = std::string_view("\\`*<>|~$&").find(c) != std::string_view::npos || (c == '_' && !in_word(i)) ||
                        (c == ']' && i + 1 < text.size() && text[i + 1] == '(');
    if (begins) out += '\\';
    out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out;
}

std::string Grid::markdown() const {
  std::string out;
  const auto line = [&](const Row& row) {
    out += "|";
    for (const std::string& cell : row) out += " " + markdown_escaped(cell) + " |";
    out += "\n";
  };
  line(heading_);
  out += "|";
  for (std::size_t c = 0; c < heading_.size(); ++c) out += c + 1 == heading_.size() ? "---|" : "---:|";
  out += "\n";
  for (const Row& row : rows_) line(row);
  return out;
}

}  // namespace gyromode::io
