#pragma once

#include <initializer_list>
#include <optional>
#include <string>

namespace gyromode {

/// A law that one part of a model breaks: at which key, and the law with the value.
struct BrokenLaw {
  std::string key;  ///< as in model files
  std::string law;  ///< in words, with the value that breaks it
};

/// Laws of single numbers; nothing where they are kept. `unit` follows the value.
std::optional<BrokenLaw> not_positive(const char* key, const char* unit, double value);
std::optional<BrokenLaw> negative(const char* key, const char* unit, double value);
std::optional<BrokenLaw> not_a_finite_number(const char* key, double value);
/// The first that is broken.
std::optional<BrokenLaw> first_broken(std::initializer_list<std::optional<BrokenLaw>> laws);

}  // namespace gyromode
