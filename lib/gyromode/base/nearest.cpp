#include "gyromode/base/nearest.h"

#include <algorithm>
#include <vector>

namespace gyromode {

namespace {

// Damerau–Levenshtein distance (optimal string alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

// Names of this field for what a key stands for; without a key: what is not served.
struct Concept {
  std::string_view word, key;
};
constexpr Concept concepts[] = {{"damping", ""},
                                {"damp", ""},
                                {"c", ""},
                                {"dashpot", ""},
                                {"viscosity", ""},
                                {"m", "mass"},
                                {"masses", "mass"},
                                {"k", "stiffness"},
                                {"stiff", "stiffness"},
                                {"spring", "stiffness"},
                                {"springs", "stiffness"},
                                {"g", "gyroscopic"},
                                {"gyro", "gyroscopic"},
                                {"coriolis", "gyroscopic"},
                                {"omega", "spin"},
                                {"rpm", "spin"},
                                {"speed", "spin"},
                                {"rotation", "spin"},
                                {"spin_rate", "spin"},
                                {"wire", "cable"},
                                {"boom", "cable"},
                                {"tether", "cable"},
                                {"rod", "beam"},
                                {"mast", "beam"},
                                {"hub", "body"},
                                {"bus", "body"},
                                {"dofs", "labels"},
                                {"names", "labels"},
                                {"axes", "frame"},
                                {"symmetrize", "symmetrise"},
                                {"j", "inertia"},
                                {"moment_of_inertia", "inertia"},
                                {"inertia", "mass"},
                                {"i", "inertia"},
                                {"constants", "parameters"},
                                {"variables", "parameters"},
                                {"lumped_mass", "spring_mass"},
                                {"density", "line_density"},
                                {"mu", "line_density"},
                                {"angle", "azimuth"},
                                {"name", "title"}};

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

}  // namespace

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
  constexpr std::size_t most_changes = 2, most_listed = 20;
  const std::string plain = lower(word.substr(0, 64));
  for (const Concept& c : concepts) {
    if (plain != c.word) continue;
    if (c.key.empty()) return ": damping is not served; leave it out for the undamped modes";
    if (std::find(known.begin(), known.end(), c.key) != known.end()) return ": did you mean '" + std::string(c.key) + "'?";
  }
  const std::string near = nearest(word, known);
  const auto differs = std::mismatch(word.begin(), word.end(), near.begin(), near.end()).first - word.begin();
  const bool same_stem = differs >= 6;  // frequency, frequencies
  if (!near.empty() && (same_stem || distance(word.substr(0, 64), near) <= std::min(most_changes, (word.size() + 1) / 2)))
    return ": did you mean '" + near + "'?";
  std::string all;
  for (std::size_t k = 0; k < known.size() && k < most_listed; ++k) all += (k == 0 ? ": one of " : ", ") + std::string(known[k]);
  return all.empty() ? "" : all + (known.size() > most_listed ? ", … was expected" : " was expected");
}

std::string nearest(std::string_view word, std::span<const std::string_view> known) {
  word = word.substr(0, 64);
  const auto best = std::min_element(known.begin(), known.end(), [&](auto a, auto b) { return distance(word, a) < distance(word, b); });
  return best == known.end() ? std::string() : std::string(*best);
}

}  // namespace gyromode
