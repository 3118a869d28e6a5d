#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gyromode {

/// The word of `known` with the fewest insertions, deletions, replacements and swaps from `word`; empty where `known`
/// is.
std::string nearest(std::string_view word, std::span<const std::string_view> known);

/// What to say after "'word' is not known": what the word means in this field, if it is a key of a model file or near
/// to one by another name (damping, rpm, wire); ": did you mean 'x'?" where a known word is within two changes; else
/// the known words.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

}  // namespace gyromode
