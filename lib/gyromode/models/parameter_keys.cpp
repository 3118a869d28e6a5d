#include "gyromode/models/parameter_keys.h"

#include "gyromode/base/error.h"
#include "gyromode/base/nearest.h"
#include "gyromode/base/number.h"
#include "gyromode/models/model_kind.h"

#include <fmt/format.h>

#include <sstream>

namespace gyromode {

bool names(std::string_view pattern, std::string_view key) {
  constexpr std::string_view every = "[*]";
  for (std::size_t at = pattern.find(every); at != std::string_view::npos; at = pattern.find(every)) {
    if (!key.starts_with(pattern.substr(0, at + 1))) return false;
    key.remove_prefix(at + 1);
    pattern.remove_prefix(at + every.size() - 1);  // both begin behind the bracket, `pattern` with its end
    const std::size_t digits = std::min(key.find_first_not_of("0123456789"), key.size());
    if (digits == 0) return false;
    key.remove_prefix(digits);
  }
  return pattern == key;
}

std::optional<std::vector<std::ptrdiff_t>> indices_of(std::string_view name, std::string_view pattern) {
  if (!pattern.starts_with(name)) return std::nullopt;
  pattern.remove_prefix(name.size());
  std::vector<std::ptrdiff_t> indices;
  while (!pattern.empty()) {
    const std::size_t close = pattern.find(']');
    if (pattern.front() != '[' || close == std::string_view::npos) return std::nullopt;
    const std::string_view inside = pattern.substr(1, close - 1);
    const auto number = whole_number(inside);
    if (inside != "*" && (!number || *number < 0)) return std::nullopt;
    indices.push_back(inside == "*" ? -1 : static_cast<std::ptrdiff_t>(*number));
    pattern.remove_prefix(close + 1);
  }
  return indices;
}

std::vector<std::string> keys_of(const std::string& keys) {
  std::vector<std::string> all;
  std::istringstream in(keys);
  for (std::string key; std::getline(in, key, ',');) all.push_back(key);
  return all;
}

Parameter require_parameter(const ModelKind& model, const std::string& keys) {
  std::optional<Parameter> first;
  for (const std::string& key : keys_of(keys)) {
    const std::optional<Parameter> found = model.parameter(key);
    if (!found) {
      std::vector<std::string> known;
      for (const Parameter& p : model.parameters()) {
        known.push_back(p.key);
        if (const std::size_t item = p.key.find("[0]."); item != std::string::npos)
          known.push_back(std::string(p.key).replace(item, 3, "[*]"));
      }
      const std::vector<std::string_view> views(known.begin(), known.end());
      if (views.empty()) throw InvalidArgument(fmt::format("'{}' is no parameter: this kind of model has none", key));
      throw InvalidArgument(fmt::format("'{}' is no parameter of the model{}", key, suggestion(key, views)));
    }
    if (first && first->dimension != found->dimension) {
      throw InvalidArgument(fmt::format("'{}' and '{}' measure different things: one value cannot be both", first->key, found->key));
    }
    if (!first) first = found;
  }
  if (!first) throw InvalidArgument("a key was expected, such as spin or body.inertia[2]");
  return *first;
}

std::optional<double> value_of(const Parameter& parameter, std::string_view text) {
  if (parameter.dimension) return parse_quantity(text, *parameter.dimension);
  const Parsed plain = parse_real(text);
  return plain.outcome == Parsed::ok ? std::optional(plain.value) : std::nullopt;
}

}  // namespace gyromode
