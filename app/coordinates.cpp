#include "coordinates.h"

#include "errors.h"

#include "gyromode/base/nearest.h"
#include "gyromode/base/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace gyromode::app {

namespace {

// Positions of `what` outside quotes. A quote opens only where a label begins: x' is a label like any other.
std::vector<std::size_t> outside_quotes(const std::string& text, char what) {
  std::vector<std::size_t> places;
  bool begins = true;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"' && begins) {
      i = std::min(text.find('"', i + 1), text.size());
      while (i + 1 < text.size() && text[i + 1] == '"') i = std::min(text.find('"', i + 2), text.size());
    } else if (text[i] == what) {
      places.push_back(i);
    }
    begins = i < text.size() && text[i] == ',';
  }
  return places;
}

// Without its quotes; as it is where it has none.
std::string unquoted(const std::string& word) {
  if (word.size() < 2 || word.front() != '"' || word.back() != '"') return word;
  std::string out;
  for (std::size_t i = 1; i + 1 < word.size(); ++i) {
    out += word[i];
    if (word[i] == '"') ++i;
  }
  return out;
}

}  // namespace

std::vector<std::string> parted(const std::string& list) {
  std::vector<std::string> pieces;
  std::size_t from = 0;
  for (const std::size_t comma : outside_quotes(list, ',')) {
    pieces.push_back(list.substr(from, comma - from));
    from = comma + 1;
  }
  pieces.push_back(list.substr(from));
  return pieces;
}

LabelAndValue label_and_value(const std::string& piece) {
  const std::vector<std::size_t> equals = outside_quotes(piece, '=');
  if (equals.empty()) return {piece, "", false};
  return {piece.substr(0, equals.back()), piece.substr(equals.back() + 1), true};
}

Index coordinate_named(const std::string& word, const Labels& labels, const std::string& context) {
  const auto as_written = std::find(labels.begin(), labels.end(), word);
  const auto at = as_written != labels.end() ? as_written : std::find(labels.begin(), labels.end(), unquoted(word));
  if (at != labels.end()) return at - labels.begin();
  if (word.size() > 1 && word.front() == '#') {
    const auto position = whole_number(word.substr(1));
    if (position && *position >= 1 && *position <= static_cast<std::int64_t>(labels.size())) return static_cast<Index>(*position - 1);
    if (position) throw UsageError(fmt::format("{}: {} is beyond the {} coordinates of the model", context, word, labels.size()));
  }
  const std::vector<std::string_view> known(labels.begin(), labels.end());
  throw UsageError(fmt::format("{}: '{}' is no coordinate of the model{}", context, word, suggestion(unquoted(word), known)));
}

}  // namespace gyromode::app
