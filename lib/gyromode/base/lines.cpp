#include "gyromode/base/lines.h"

#include <algorithm>

namespace gyromode {

// Continuation bytes take no column, nor do U+0300 … U+036F: bytes CC 80 … CD AF.
std::size_t columns_of(std::string_view text) {
  std::size_t columns = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
    const bool combines = byte == 0xCC || (byte == 0xCD && next < 0xB0);
    if ((byte & 0xC0) != 0x80 && !combines) ++columns;
  }
  return columns;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t columns) {
  std::vector<std::string> lines(1);
  std::size_t used = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t width = columns_of(word);
    if (used > 0 && used + 1 + width > columns) {
      lines.emplace_back();
      used = 0;
    }
    if (used > 0) lines.back() += ' ';
    lines.back() += word;
    used += width + (used > 0 ? 1 : 0);
  }
  return lines;
}

std::string wrapped_with_indent(std::string_view text, std::size_t columns, std::size_t indent) {
  std::string all;
  for (const std::string& line : wrapped(text, columns)) all += (all.empty() ? "" : "\n" + std::string(indent, ' ')) + line;
  return all;
}

}  // namespace gyromode
