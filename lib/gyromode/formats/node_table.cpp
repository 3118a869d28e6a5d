#include "gyromode/formats/node_table.h"

#include "gyromode/base/error.h"
#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <unordered_map>

namespace gyromode::io {

namespace {

constexpr std::string_view parts = ", ;\t\r";

// The next word of a line, which loses it.
std::string_view word_of(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(parts), line.size()));
  const std::size_t end = std::min(line.find_first_of(parts), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

template <class Number>
bool read(std::string_view word, Number& x) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto r = std::from_chars(word.data(), word.data() + word.size(), x);
  return r.ec == std::errc() && r.ptr == word.data() + word.size();
}

// NODE of "*Node, nset=all".
std::string keyword_of(std::string_view line) {
  std::string word(line.substr(1, std::min(line.find(','), line.size()) - 1));
  while (!word.empty() && std::isspace(static_cast<unsigned char>(word.back()))) word.pop_back();
  for (char& c : word) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return word;
}

}  // namespace

std::vector<MeshNode> read_nodes(const std::filesystem::path& file) {
  const std::string text = read_text(file, "node coordinates (a *NODE block, or lines node,x,y,z)");
  std::vector<MeshNode> all;
  std::unordered_map<long, std::size_t> seen;
  std::size_t number = 0;
  bool deck = false, in_nodes = true, first = true;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = std::string_view(text).substr(at, end - at);
    at = end + 1;
    ++number;
    line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
    if (line.empty() || line.starts_with("**") || line.starts_with('#')) continue;
    if (line.starts_with('*')) {
      deck = true;
      in_nodes = keyword_of(line) == "NODE";
      continue;
    }
    if (!in_nodes) continue;
    MeshNode n;
    std::string_view rest = line;
    const std::string_view name = word_of(rest);
    const bool counted = read(name, n.node) && n.node > 0;
    if (!counted && first && !deck) {  // names of the columns
      first = false;
      continue;
    }
    first = false;
    if (!counted) throw Unreadable(file, number, 0, fmt::format("'{}' is no number of a node: node,x,y,z was expected", shown(name)));
    std::size_t given = 0;
    for (std::string_view word = word_of(rest); !word.empty(); word = word_of(rest)) {
      if (given == 3)
        throw Unreadable(file, number, 0, fmt::format("'{}' is one too many on its line: node,x,y,z was expected", shown(word)));
      if (!read(word, n.at[given]) || !std::isfinite(n.at[given]))
        throw Unreadable(file, number, 0, fmt::format("'{}' is no coordinate of node {}: a number was expected", shown(word), n.node));
      ++given;
    }
    if (given < 3 && !deck)
      throw Unreadable(file, number, 0, fmt::format("node {} has {} coordinates: node,x,y,z was expected", n.node, given));
    const auto [before, fresh] = seen.emplace(n.node, number);
    if (!fresh) throw Unreadable(file, number, 0, fmt::format("node {} is given a second time (first on line {})", n.node, before->second));
    all.push_back(n);
  }
  if (all.empty())
    throw Unreadable(file, deck ? "has no *NODE block with nodes in it (an *INCLUDE is not followed: name that file instead)"
                                : "is empty: lines node,x,y,z were expected");
  return all;
}

}  // namespace gyromode::io
