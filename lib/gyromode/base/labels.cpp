#include "gyromode/base/labels.h"

#include "gyromode/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

namespace gyromode {

Labels default_labels(Index n) {
  Labels labels(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = fmt::format("q{}", i + 1);
  return labels;
}

bool has_control_character(std::string_view label) {
  return std::any_of(label.begin(), label.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

Labels labels_at(const Labels& labels, const std::vector<Index>& which) {
  Labels some;
  for (const Index i : which) some.push_back(labels[static_cast<std::size_t>(i)]);
  return some;
}

void require_labels(const Labels& labels, Index n) {
  if (static_cast<Index>(labels.size()) != n) {
    throw LawBroken(fmt::format("labels must name every coordinate once: {} labels for {} coordinates", labels.size(), n));
  }
  std::unordered_set<std::string_view> seen;
  for (const std::string& label : labels) {
    if (label.empty()) throw LawBroken("labels must not be empty");
    if (has_control_character(label)) throw LawBroken("labels must print on one line: one has a control character");
    if (!seen.insert(label).second) throw LawBroken(fmt::format("labels must differ: '{}' is given twice", label));
  }
}

}  // namespace gyromode
