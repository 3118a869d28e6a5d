#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gyromode {

/// The word of `known` with the fewest insertions, deletions, replacements and swaps from `word`; empty where `known`
/// is.
std::string nearest(std::string_view word, std::span<const std::string_view> known);

}  // namespace gyromode
