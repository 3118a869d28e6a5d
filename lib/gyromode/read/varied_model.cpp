#include "gyromode/read/varied_model.h"

#include "gyromode/base/error.h"
#include "gyromode/formats/nearest.h"
#include "gyromode/base/number.h"
#include "gyromode/formats/text_file.h"
#include "gyromode/read/toml_text.h"
#include "gyromode/base/quantity.h"

#include <fmt/format.h>

#include <sstream>

namespace gyromode::io {

struct VariedModel::Document {
  toml::table table;
};

namespace {

// A step of a path: a key of a table, or an item of an array, −1 for all.
struct Step {
  std::string key;
  std::int64_t item = 0;
};

constexpr std::int64_t every = -1;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

std::optional<std::vector<Step>> steps_of(const std::string& path) {
  std::vector<Step> steps;
  for (const std::string& part : split(path, '.')) {
    const std::size_t bracket = part.find('[');
    if (bracket == 0 || part.empty()) return std::nullopt;
    steps.push_back({part.substr(0, bracket), 0});
    for (std::string rest = bracket == std::string::npos ? "" : part.substr(bracket); !rest.empty();) {
      const std::size_t close = rest.find(']');
      if (rest.front() != '[' || close == std::string::npos) return std::nullopt;
      const std::string inside = rest.substr(1, close - 1);
      const auto number = whole_number(inside);
      if (inside != "*" && (!number || *number < 0)) return std::nullopt;
      steps.push_back({"", inside == "*" ? every : *number});
      rest = rest.substr(close + 1);
    }
  }
  if (steps.empty()) return std::nullopt;
  return steps;
}

bool is_quantity(const toml::node& node) {
  if (node.is_number()) return true;
  const auto text = node.value<std::string>();
  return text && node.is_string() && parse_any_quantity(*text).has_value();
}

// Calls `found(parent array or table, key or position)` at every number the path leads to; false where it leads to none, or to what is no number.
template <class Found>
bool follow(toml::node& node, std::span<const Step> steps, Found&& found) {
  if (steps.empty()) return is_quantity(node) && (found(node), true);
  const Step& step = steps.front();
  if (!step.key.empty()) {
    auto* table = node.as_table();
    toml::node* next = table ? table->get(step.key) : nullptr;
    return next && follow(*next, steps.subspan(1), found);
  }
  auto* array = node.as_array();
  if (!array || array->empty()) return false;
  if (step.item != every) return static_cast<std::size_t>(step.item) < array->size() && follow(*array->get(static_cast<std::size_t>(step.item)), steps.subspan(1), found);
  bool all = true;
  for (toml::node& item : *array) all = follow(item, steps.subspan(1), found) && all;
  return all;
}

// Every path that leads to a number, [known] left out.
void collect(const toml::node& node, const std::string& path, std::vector<std::string>& to) {
  if (const auto* table = node.as_table()) {
    for (const auto& [key, value] : *table) {
      if (path.empty() && (key.str() == "known" || key.str() == "title" || key.str() == "reference")) continue;
      collect(value, path.empty() ? std::string(key.str()) : path + "." + std::string(key.str()), to);
    }
  } else if (const auto* array = node.as_array()) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      collect(*array->get(i), fmt::format("{}[{}]", path, i), to);
      if (i == 0 && array->get(0)->is_table()) collect(*array->get(0), path + "[*]", to);
    }
  } else if (is_quantity(node)) {
    to.push_back(path);
  }
}

// What a model is known by, and not made of.
bool is_description(const std::string& key) { return key == "known" || key == "title" || key == "reference"; }

bool leads_to_numbers(toml::table& table, const std::string& path) {
  const auto steps = steps_of(path);
  if (steps && is_description(steps->front().key)) return false;
  return steps && follow(table, *steps, [](toml::node&) {});
}

// Strings and integers become floating-point numbers; a node cannot change its type in place, so the number is put where its parent holds it.
void set(toml::node& node, std::span<const Step> steps, double value) {
  const Step& step = steps.front();
  const auto put = [&](toml::node& next, auto&& replace) {
    if (steps.size() == 1) replace();
    else set(next, steps.subspan(1), value);
  };
  if (!step.key.empty()) {
    auto& table = *node.as_table();
    put(*table.get(step.key), [&] { table.insert_or_assign(step.key, value); });
    return;
  }
  auto& array = *node.as_array();
  for (std::size_t i = 0; i < array.size(); ++i) {
    if (step.item != every && static_cast<std::size_t>(step.item) != i) continue;
    put(*array.get(i), [&] { array.replace(array.cbegin() + static_cast<std::ptrdiff_t>(i), value); });
  }
}

}  // namespace

std::optional<double> parse_value_of(const std::string& key, std::string_view text) {
  const std::string first = split(key, ',').empty() ? key : split(key, ',').front();
  std::string name = first.substr(first.rfind('.') == std::string::npos ? 0 : first.rfind('.') + 1);
  name = name.substr(0, name.find('['));
  constexpr std::pair<std::string_view, Dimension> dimensions[] = {
      {"spin", Dimension::frequency}, {"length", Dimension::length}, {"radius", Dimension::length}, {"height", Dimension::length}, {"root", Dimension::length},
      {"position", Dimension::length}, {"azimuth", Dimension::angle}, {"mass", Dimension::mass}, {"tip_mass", Dimension::mass}, {"line_density", Dimension::line_density},
      {"inertia", Dimension::inertia}, {"stiffness", Dimension::stiffness}, {"bending_stiffness", Dimension::bending_stiffness}};
  for (const auto& [known, dimension] : dimensions) {
    if (known == name) return parse_quantity(text, dimension);
  }
  const Parsed plain = parse_real(text);
  return plain.outcome == Parsed::ok ? std::optional(plain.value) : std::nullopt;
}

std::optional<double> parse_any_quantity(std::string_view text) {
  for (const Dimension d : {Dimension::frequency, Dimension::length, Dimension::angle, Dimension::mass, Dimension::line_density, Dimension::inertia, Dimension::stiffness,
                            Dimension::bending_stiffness}) {
    if (const auto value = parse_quantity(text, d)) return value;
  }
  return std::nullopt;
}

VariedModel::VariedModel(const std::filesystem::path& file) : VariedModel(read_text(file, "TOML model"), file) {}

VariedModel::VariedModel(std::string_view text, const std::filesystem::path& name) : name_(name) {
  parse_model(text, name);  // says what is wrong with it, with line and column
  document_ = std::make_unique<const Document>(Document{parse_toml(text, name)});
}

VariedModel::~VariedModel() = default;

void VariedModel::require_key(const std::string& keys) const {
  toml::table table = document_->table;
  const std::vector<std::string> paths = split(keys, ',');
  if (paths.empty()) throw InvalidArgument("a key was expected, such as spin or body.inertia[2]");
  for (const std::string& path : paths) {
    if (leads_to_numbers(table, path)) continue;
    std::vector<std::string> known;
    collect(table, "", known);
    const std::vector<std::string_view> views(known.begin(), known.end());
    if (views.empty()) throw InvalidArgument(fmt::format("'{}' leads to no number in {}, which has none outside its matrix files", path, name_.string()));
    throw InvalidArgument(fmt::format("'{}' leads to no number in {}: did you mean '{}'?", path, name_.string(), nearest(path, views)));
  }
}

Model VariedModel::at(const std::vector<std::string>& keys, const std::vector<double>& values) const {
  toml::table table = document_->table;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    for (const std::string& path : split(keys[k], ',')) set(table, *steps_of(path), values[k]);
  }
  std::ostringstream text;
  text << table;
  return parse_model(text.str(), name_);
}

}  // namespace gyromode::io
