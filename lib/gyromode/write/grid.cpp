#include "gyromode/write/grid.h"

#include <algorithm>

namespace gyromode::io {

namespace {

std::size_t width(const std::string& s) {
  return static_cast<std::size_t>(std::count_if(s.begin(), s.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

std::string Grid::aligned() const {
  std::vector<std::size_t> widths;
  for (const std::string& h : heading_) widths.push_back(width(h));
  for (const auto& row : rows_) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width(row[c]));
  }
  std::string out;
  const auto line = [&](const std::vector<std::string>& row) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string pad(widths[c] - width(row[c]), ' ');
      out += c + 1 == row.size() ? "  " + row[c] : "  " + pad + row[c];
    }
    out += "\n";
  };
  line(heading_);
  for (const auto& row : rows_) line(row);
  return out;
}

std::string Grid::markdown() const {
  std::string out;
  const auto line = [&](const std::vector<std::string>& row) {
    out += "|";
    for (std::string cell : row) {
      for (std::size_t at = 0; (at = cell.find('|', at)) != std::string::npos; at += 2) cell.insert(at, "\\");
      out += " " + cell + " |";
    }
    out += "\n";
  };
  line(heading_);
  out += "|";
  for (std::size_t c = 0; c < heading_.size(); ++c) out += c + 1 == heading_.size() ? "---|" : "---:|";
  out += "\n";
  for (const auto& row : rows_) line(row);
  return out;
}

}  // namespace gyromode::io
