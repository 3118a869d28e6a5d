#include "gyromode/read/toml_table.h"

#include "gyromode/base/error.h"
#include "gyromode/formats/matrix_file.h"
#include "gyromode/base/nearest.h"
#include "gyromode/formats/text_file.h"
#include "gyromode/read/formulas.h"
#include "gyromode/read/labels_file.h"
#include "gyromode/read/toml_text.h"
#include "gyromode/system/laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <system_error>

namespace gyromode::io {

struct TomlTable::Content {
  std::shared_ptr<const toml::table> document;  // whole: a copy of a part would not know its lines
  const toml::table& table;
  std::filesystem::path file;
  std::shared_ptr<const Formulas> formulas;  // of the document
  [[nodiscard]] Content part(const toml::table& inner) const { return {document, inner, file, formulas}; }
};

namespace {

std::string_view type_word(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string: return "a string";
    case toml::node_type::integer:
    case toml::node_type::floating_point: return "a number";
    case toml::node_type::boolean: return "true or false";
    case toml::node_type::array: return "an array";
    case toml::node_type::table: return "a table";
    default: return "a date or time";
  }
}

[[noreturn]] void fail_at(const std::filesystem::path& file, const toml::node& node, const std::string& message) {
  throw Unreadable(file, node.source().begin.line, node.source().begin.column, message);
}

double finite_number(const std::filesystem::path& file, const toml::node& node, std::string_view what) {
  // An integer that no double holds exactly is rounded, as a decimal would be; toml++ gives nothing for it as a double.
  const auto whole = node.value_exact<std::int64_t>();
  const std::optional<double> value = whole ? static_cast<double>(*whole) : node.value<double>();
  if (!node.is_number() || !value) fail_at(file, node, fmt::format("{} is {}: a number was expected", what, type_word(node)));
  if (!std::isfinite(*value)) fail_at(file, node, fmt::format("{} is {}: a finite number was expected", what, *value));
  return *value;
}

// A number, or a formula of the parameters.
double number_or_formula(const std::filesystem::path& file, const toml::node& node, const Formulas& formulas, const std::string& what) {
  if (!node.is_string()) return finite_number(file, node, what);
  const std::string written = *node.value<std::string>();
  const Formulas::Value v = formulas.evaluate(written);
  if (v.fault) fail_at(file, node, fmt::format("{} = \"{}\": {}", what, shown(written), v.fault->message));
  return v.value;
}

// The value of a parameter: a number, a quantity with its unit, or a formula of those before it.
std::pair<double, std::optional<Dimension>> parameter_value(const std::filesystem::path& file, const toml::node& node,
                                                            const Formulas& before, const std::string& what) {
  if (node.is_string()) {
    const std::string written = *node.value<std::string>();
    for (const Dimension d : {Dimension::frequency, Dimension::length, Dimension::angle, Dimension::mass, Dimension::line_density,
                              Dimension::inertia, Dimension::stiffness, Dimension::bending_stiffness}) {
      if (const auto value = parse_quantity(written, d)) return {*value, d};
    }
  }
  return {number_or_formula(file, node, before, what), std::nullopt};
}

std::shared_ptr<const Formulas> formulas_of(const toml::table& document, const std::filesystem::path& file,
                                            const std::vector<ParameterValue>& instead) {
  auto formulas = std::make_shared<Formulas>();
  const toml::node* node = document.get("parameters");
  if (!node) return formulas;
  if (!node->is_table()) fail_at(file, *node, fmt::format("'parameters' is {}: a table [parameters] was expected", type_word(*node)));
  // A table is sorted by its names: those that a formula needs are earlier in the file.
  std::vector<std::pair<std::string, const toml::node*>> in_order;
  for (const auto& [name, value] : *node->as_table()) in_order.emplace_back(std::string(name.str()), &value);
  std::sort(in_order.begin(), in_order.end(), [](const auto& a, const auto& b) {
    const auto &p = a.second->source().begin, &q = b.second->source().begin;
    return p.line != q.line ? p.line < q.line : p.column < q.column;
  });
  for (const auto& entry : in_order) {
    const std::string& name = entry.first;
    const toml::node* value = entry.second;
    const auto other = std::find_if(instead.begin(), instead.end(), [&](const ParameterValue& v) { return v.key == name; });
    auto [number, dimension] = parameter_value(file, *value, *formulas, fmt::format("parameter '{}'", shown(name)));
    if (other != instead.end()) number = other->value;
    if (const auto fault = formulas->add(name, number, dimension)) fail_at(file, *value, "parameter " + fault->message);
  }
  return formulas;
}

// Rows of numbers or formulas; or a list of them, the diagonal.
Matrix inline_rows(const std::filesystem::path& file, const toml::array& rows, std::string_view key, const Formulas& formulas) {
  if (!rows.empty() && (rows.get(0)->is_number() || rows.get(0)->is_string())) {
    Vector diagonal(static_cast<Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
      diagonal(static_cast<Index>(i)) =
          number_or_formula(file, *rows.get(i), formulas, fmt::format("number {} of the diagonal '{}'", i + 1, key));
    return diagonal.asDiagonal();
  }
  const auto* first = rows.empty() ? nullptr : rows.get(0)->as_array();
  if (!first || first->empty()) fail_at(file, rows, fmt::format("'{}' has no rows: [[…], […]] was expected", key));
  Matrix a(static_cast<Index>(rows.size()), static_cast<Index>(first->size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto* row = rows.get(i)->as_array();
    if (!row)
      fail_at(file, *rows.get(i),
              fmt::format("row {} of '{}' is {}: an array of numbers was expected", i + 1, key, type_word(*rows.get(i))));
    if (row->size() != first->size()) {
      fail_at(file, *row,
              fmt::format("row {} of '{}' has {} numbers: {} were expected, as in row 1", i + 1, key, row->size(), first->size()));
    }
    for (std::size_t j = 0; j < row->size(); ++j) {
      a(static_cast<Index>(i), static_cast<Index>(j)) =
          number_or_formula(file, *row->get(j), formulas, fmt::format("entry ({},{}) of '{}'", i + 1, j + 1, key));
    }
  }
  return a;
}

}  // namespace

TomlTable::TomlTable(std::string_view text, const std::filesystem::path& file) {
  const auto document = std::make_shared<const toml::table>(parse_toml(text, file));
  content_ = std::make_shared<const Content>(Content{document, *document, file, formulas_of(*document, file, {})});
}

const std::vector<Parameter>& TomlTable::parameters() const { return content_->formulas->parameters(); }

TomlTable TomlTable::with_parameters(const std::vector<ParameterValue>& values) const {
  return TomlTable(std::make_shared<const Content>(
      Content{content_->document, content_->table, content_->file, formulas_of(*content_->document, content_->file, values)}));
}

TomlTable::TomlTable(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

void TomlTable::allow_only(std::span<const std::string_view> keys) const {
  for (const auto& [key, value] : content_->table) {
    if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
    throw Unreadable(content_->file, key.source().begin.line, key.source().begin.column,
                     fmt::format("key '{}' is not known here{}", shown(key.str()), suggestion(key.str(), keys)));
  }
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
  const toml::node* node = content_->table.get(key);
  if (!node) return std::nullopt;
  if (!node->is_string()) fail(key, fmt::format("'{}' is {}: a string was expected", key, type_word(*node)));
  return node->value<std::string>();
}

bool TomlTable::has(std::string_view key) const { return content_->table.get(key) != nullptr; }

std::filesystem::path TomlTable::folder() const { return content_->file.parent_path(); }

bool TomlTable::is_text(std::string_view key) const {
  const toml::node* node = content_->table.get(key);
  return node && node->is_string();
}

bool TomlTable::is_array(std::string_view key) const { return has(key) && content_->table.get(key)->is_array(); }

std::vector<std::string> TomlTable::texts_or_file(std::string_view key) const {
  const toml::node* node = content_->table.get(key);
  if (node && node->is_string()) return read_labels(content_->file.parent_path() / *node->value<std::string>());
  if (node && !node->is_array())
    fail(key, fmt::format("'{}' is {}: an array of strings, or a file of them, was expected", key, type_word(*node)));
  return words(key);
}

std::vector<std::string> TomlTable::words(std::string_view key) const {
  std::vector<std::string> all;
  const toml::node* node = content_->table.get(key);
  if (!node) return all;
  if (node->is_string()) return {*node->value<std::string>()};
  if (!node->is_array()) fail(key, fmt::format("'{}' is {}: an array of strings was expected", key, type_word(*node)));
  for (const toml::node& item : *node->as_array()) {
    if (!item.is_string()) fail_at(content_->file, item, fmt::format("an item of '{}' is {}: a string was expected", key, type_word(item)));
    all.push_back(*item.value<std::string>());
  }
  return all;
}

std::vector<std::array<std::string, 2>> TomlTable::pairs_of_words(std::string_view key) const {
  std::vector<std::array<std::string, 2>> all;
  const toml::node* node = content_->table.get(key);
  if (!node) return all;
  const auto refuse = [&](const toml::node& at) {
    fail_at(content_->file, at, fmt::format("'{}' is an array of pairs of names, such as [[\"x1\", \"y1\"], [\"x2\", \"y2\"]]", key));
  };
  if (!node->is_array()) refuse(*node);
  for (const toml::node& item : *node->as_array()) {
    const toml::array* pair = item.as_array();
    if (!pair || pair->size() != 2 || !(*pair)[0].is_string() || !(*pair)[1].is_string()) refuse(item);
    all.push_back({*(*pair)[0].value<std::string>(), *(*pair)[1].value<std::string>()});
  }
  return all;
}

std::vector<double> TomlTable::numbers(std::string_view key) const {
  std::vector<double> all;
  const toml::node* node = content_->table.get(key);
  if (!node) return all;
  if (!node->is_array()) fail(key, fmt::format("'{}' is {}: an array of numbers was expected", key, type_word(*node)));
  for (const toml::node& item : *node->as_array()) all.push_back(finite_number(content_->file, item, fmt::format("an item of '{}'", key)));
  return all;
}

std::optional<double> TomlTable::number(std::string_view key) const {
  const toml::node* node = content_->table.get(key);
  if (!node) return std::nullopt;
  return finite_number(content_->file, *node, fmt::format("'{}'", key));
}

std::optional<double> TomlTable::frequency(std::string_view key) const {
  const toml::node* node = content_->table.get(key);
  if (!node) return std::nullopt;
  if (node->is_number()) return finite_number(content_->file, *node, fmt::format("'{}'", key));
  if (!node->is_string()) fail(key, fmt::format("'{}' is {}: {} was expected", key, type_word(*node), frequency_form));
  const std::string written = *node->value<std::string>();
  if (const auto value = parse_frequency(written)) return value;
  if (const auto value = content_->formulas->evaluate(written); !value.fault) return value.value;
  fail(key, fmt::format("'{}' = \"{}\" is no frequency: {} was expected", key, shown(written), frequency_form));
}

namespace {

double quantity_of(const std::filesystem::path& file, const toml::node& node, const std::string& what, Dimension dimension, bool infinite,
                   const Formulas& formulas) {
  if (infinite && node.is_floating_point() && std::isinf(*node.value<double>()) && *node.value<double>() > 0) return *node.value<double>();
  if (node.is_number()) return finite_number(file, node, what);
  if (!node.is_string()) fail_at(file, node, fmt::format("{} is {}: {} was expected", what, type_word(node), form_of(dimension)));
  const std::string written = *node.value<std::string>();
  if (const auto value = parse_quantity(written, dimension)) return *value;
  const Formulas::Value value = formulas.evaluate(written);
  if (!value.fault) return value.value;
  const std::string why = formulas.parameters().empty() ? "" : fmt::format(", or a formula of the parameters: {}", value.fault->message);
  fail_at(file, node, fmt::format("{} = \"{}\": {} was expected{}", what, shown(written), form_of(dimension), why));
}

}  // namespace

std::optional<double> TomlTable::quantity(std::string_view key, Dimension dimension, bool infinite) const {
  const toml::node* node = content_->table.get(key);
  if (!node) return std::nullopt;
  return quantity_of(content_->file, *node, fmt::format("'{}'", key), dimension, infinite, *content_->formulas);
}

std::vector<double> TomlTable::quantities(std::string_view key, Dimension dimension, std::size_t count, bool infinite) const {
  std::vector<double> all;
  const toml::node* node = content_->table.get(key);
  if (!node) return all;
  const toml::array* items = node->as_array();
  if (!items) fail(key, fmt::format("'{}' is {}: {} values were expected, [ … ]", key, type_word(*node), count));
  if (items->size() != count) fail(key, fmt::format("'{}' has {} values: {} were expected", key, items->size(), count));
  for (std::size_t i = 0; i < count; ++i)
    all.push_back(
        quantity_of(content_->file, *items->get(i), fmt::format("value {} of '{}'", i + 1, key), dimension, infinite, *content_->formulas));
  return all;
}

std::optional<Matrix> TomlTable::diagonal_or_matrix(std::string_view key, Dimension dimension, std::size_t count) const {
  const toml::node* node = content_->table.get(key);
  if (!node) return std::nullopt;
  const toml::array* items = node->as_array();
  if (items && !items->empty() && items->get(0)->is_array()) {
    const Matrix rows = inline_rows(content_->file, *items, key, *content_->formulas);
    if (rows.rows() != static_cast<Index>(count) || rows.cols() != rows.rows()) {
      fail(key, fmt::format("'{}' is {} × {}: {} values or {} × {} were expected", key, rows.rows(), rows.cols(), count, count, count));
    }
    return rows;
  }
  const std::vector<double> diagonal = quantities(key, dimension, count);
  return Matrix(Eigen::Map<const Vector>(diagonal.data(), static_cast<Index>(count)).asDiagonal());
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  std::vector<TomlTable> all;
  const toml::node* node = content_->table.get(key);
  if (!node) return all;
  const toml::array* items = node->as_array();
  if (!items) fail(key, fmt::format("'{}' is {}: tables [[{}]] were expected", key, type_word(*node), key));
  for (const toml::node& item : *items) {
    if (!item.is_table())
      fail_at(content_->file, item, fmt::format("an item of '{}' is {}: a table [[{}]] was expected", key, type_word(item), key));
    all.push_back(TomlTable(std::make_shared<const Content>(content_->part(*item.as_table()))));
  }
  return all;
}

std::vector<std::pair<std::string, TomlTable>> TomlTable::named_tables(std::string_view key) const {
  std::vector<std::pair<std::string, TomlTable>> all;
  const toml::node* node = content_->table.get(key);
  if (!node) return all;
  if (!node->is_table()) fail(key, fmt::format("'{}' is {}: tables [{}.NAME] were expected", key, type_word(*node), key));
  std::vector<std::pair<const toml::key*, const toml::table*>> found;
  for (const auto& [name, item] : *node->as_table()) {
    if (!item.is_table())
      fail_at(content_->file, item, fmt::format("'{}.{}' is {}: a table [{}.NAME] was expected", key, name.str(), type_word(item), key));
    found.emplace_back(&name, item.as_table());
  }
  const auto place = [](const auto& entry) { return std::pair(entry.second->source().begin.line, entry.second->source().begin.column); };
  std::sort(found.begin(), found.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
  for (const auto& [name, table] : found)
    all.emplace_back(std::string(name->str()), TomlTable(std::make_shared<const Content>(content_->part(*table))));
  return all;
}

std::optional<TomlTable> TomlTable::table(std::string_view key) const {
  const toml::node* node = content_->table.get(key);
  if (!node) return std::nullopt;
  if (!node->is_table()) fail(key, fmt::format("'{}' is {}: a table [{}] was expected", key, type_word(*node), key));
  return TomlTable(std::make_shared<const Content>(content_->part(*node->as_table())));
}

std::optional<NamedMatrix> TomlTable::matrix(std::string_view key, Digest& digest) const {
  const toml::node* node = content_->table.get(key);
  if (!node) return std::nullopt;
  if (const auto* rows = node->as_array())
    return NamedMatrix{std::string(key), inline_rows(content_->file, *rows, key, *content_->formulas)};
  if (!node->is_string()) fail(key, fmt::format("'{}' is {}: a matrix file or rows of numbers was expected", key, type_word(*node)));
  const std::string written = *node->value<std::string>();
  const MatrixPlace place = matrix_place(content_->file.parent_path() / written);
  std::error_code error;
  if (!std::filesystem::exists(place.file, error))
    fail(key, fmt::format("'{}' names '{}', which does not exist: a matrix file was expected", key, shown(written)));
  const std::string bytes = read_bytes(place.file, "matrix");
  digest.add(place.file, bytes);
  NamedMatrix found = chosen_matrix(parse_matrices(bytes, place.file, most_coordinates), place);
  if (std::min(found.matrix.rows(), found.matrix.cols()) == 1) make_square(found, place.file);
  return found;
}

void TomlTable::fail(std::string_view key, const std::string& message) const {
  fail_at(content_->file, *content_->table.get(key), message);
}
void TomlTable::break_law(std::string_view key, const std::string& law) const {
  const toml::node* node = content_->table.get(key);
  const auto& at = (node ? node->source() : content_->table.source()).begin;
  throw LawBroken(content_->file, at.line, at.column, law);
}
void TomlTable::fail(const std::string& message) const {
  const std::size_t line = content_->table.source().begin.line;
  throw Unreadable(content_->file, line, 0, message);
}

}  // namespace gyromode::io
