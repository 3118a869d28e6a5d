#include "gyromode/formats/dof_table.h"

#include "gyromode/base/error.h"
#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <string_view>

namespace gyromode::io {

std::vector<MeshDof> read_dof_table(const std::filesystem::path& file) {
  const std::string text = read_text(file, "dof table (lines node.direction)");
  std::vector<MeshDof> all;
  std::map<std::pair<long, int>, std::size_t> seen;
  std::size_t number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = std::string_view(text).substr(at, end - at);
    at = end + 1;
    ++number;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    if (line.empty()) continue;
    MeshDof d;
    const char *first = line.data(), *last = first + line.size();
    const auto node = std::from_chars(first, last, d.node);
    const bool point = node.ec == std::errc() && node.ptr < last && *node.ptr == '.';
    const auto direction = point ? std::from_chars(node.ptr + 1, last, d.direction) : node;
    if (!point || direction.ec != std::errc() || direction.ptr != last || d.node < 1 || d.direction < 1 || d.direction > 6)
      throw Unreadable(file, number, 0, fmt::format("'{}' is no coordinate: node.direction was expected, such as 17.2", shown(line)));
    const auto [before, fresh] = seen.emplace(std::pair(d.node, d.direction), number);
    if (!fresh)
      throw Unreadable(file, number, 0, fmt::format("'{}' is given a second time (first on line {})", shown(line), before->second));
    all.push_back(d);
  }
  if (all.empty()) throw Unreadable(file, "is empty: a line node.direction a coordinate was expected");
  return all;
}

}  // namespace gyromode::io
