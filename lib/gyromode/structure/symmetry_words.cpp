#include "gyromode/structure/symmetry_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace gyromode {

namespace {

constexpr double clear_entry = 1e-6;  // of a reflection whose entries are near 1: smaller ones are rounding

const std::string& label(const Labels& labels, Index i) { return labels[static_cast<std::size_t>(i)]; }

// The only other coordinate that i meets, −1 where there is none; nothing where there are several.
std::optional<Index> partner(const Matrix& r, Index i) {
  Index found = -1;
  for (Index k = 0; k < r.rows(); ++k) {
    if (k == i || (std::abs(r(i, k)) <= clear_entry && std::abs(r(k, i)) <= clear_entry)) continue;
    if (found >= 0) return std::nullopt;
    found = k;
  }
  return found;
}

struct Pairs {
  std::vector<Index> kept, reversed;
  std::vector<std::pair<Index, Index>> mixed;
};

std::optional<Pairs> pairs_of(const Matrix& r) {
  Pairs pairs;
  for (Index i = 0; i < r.rows(); ++i) {
    const auto other = partner(r, i);
    if (!other) return std::nullopt;
    if (*other < 0)
      (r(i, i) > 0 ? pairs.kept : pairs.reversed).push_back(i);
    else if (*other > i)
      pairs.mixed.emplace_back(i, *other);
  }
  return pairs;
}

// Angle of the mirror line from coordinate i towards k of [cos 2φ, sin 2φ; sin 2φ, −cos 2φ], degrees in (−90, 90];
// nothing where the block is no orthogonal reflection.
std::optional<double> mirror_angle(const Matrix& r, Index i, Index k) {
  if (std::abs(r(i, k) - r(k, i)) > clear_entry || std::abs(r(i, i) + r(k, k)) > clear_entry) return std::nullopt;
  return 90 / std::numbers::pi * std::atan2(r(i, k), r(i, i));
}

std::string listed(const Labels& labels, const std::vector<Index>& at) { return fmt::format("{}", fmt::join(chosen(labels, at), ", ")); }

}  // namespace

Labels chosen(const Labels& labels, const std::vector<Index>& at) {
  Labels some;
  for (const Index i : at) some.push_back(label(labels, i));
  return some;
}

std::string in_words(const Matrix& r, const Labels& labels) {
  const Index n = r.rows();
  const Index plus = static_cast<Index>(std::lround(0.5 * (static_cast<double>(n) + r.trace())));
  const std::string groups = fmt::format("{} in phase, {} in quadrature", plus, n - plus);
  const auto pairs = pairs_of(r);
  if (!pairs) return fmt::format("a reflection that mixes the coordinates: {}", groups);
  std::vector<std::string> parts;
  std::optional<double> common;
  std::vector<std::string> planes;
  bool one_angle = true;
  for (const auto& [i, k] : pairs->mixed) {
    const auto angle = mirror_angle(r, i, k);
    if (!angle) return fmt::format("a reflection that mixes the coordinates in pairs: {}", groups);
    const bool exchange = std::abs(r(i, i)) <= clear_entry;
    if (exchange) {
      parts.push_back(r(i, k) > 0 ? fmt::format("{} ↔ {}", label(labels, i), label(labels, k))
                                  : fmt::format("{} ↔ −{}", label(labels, i), label(labels, k)));
      continue;
    }
    one_angle = one_angle && (!common || std::abs(*angle - *common) <= clear_entry * 90);
    common = angle;
    planes.push_back(fmt::format("({}, {})", label(labels, i), label(labels, k)));
  }
  if (common && !one_angle) return fmt::format("a reflection that mixes the coordinates in pairs: {}", groups);
  std::string words = "a mirror or half-turn";
  if (common)
    words += fmt::format(" along the line at {:.6g}° in the plane{} {}", *common, planes.size() > 1 ? "s" : "", fmt::join(planes, ", "));
  std::vector<std::string> does;
  if (!parts.empty()) does.push_back(fmt::format("exchanges {}", fmt::join(parts, ", ")));
  if (!pairs->reversed.empty()) does.push_back("reverses " + listed(labels, pairs->reversed));
  if (!pairs->kept.empty()) does.push_back("keeps " + listed(labels, pairs->kept));
  if (!does.empty()) words += fmt::format("{} that {}", common ? "," : "", fmt::join(does, ", "));
  return fmt::format("{}: {}", words, groups);
}

}  // namespace gyromode
