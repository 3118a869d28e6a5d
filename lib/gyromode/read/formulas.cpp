#include "gyromode/read/formulas.h"

#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>

namespace gyromode::io {

namespace {

using Function = double (*)(double);
constexpr std::pair<const char*, Function> functions[] = {
    {"sin", std::sin},   {"cos", std::cos},   {"tan", std::tan},     {"asin", std::asin}, {"acos", std::acos},
    {"atan", std::atan}, {"sinh", std::sinh}, {"cosh", std::cosh},   {"tanh", std::tanh}, {"sqrt", std::sqrt},
    {"exp", std::exp},   {"log", std::log},   {"log10", std::log10}, {"abs", std::fabs}};
constexpr std::array<std::string_view, 4> more_names{"atan2", "min", "max", "pi"};

double least(const double* values, int count) { return *std::min_element(values, values + count); }
double largest(const double* values, int count) { return *std::max_element(values, values + count); }

void define_functions(mu::Parser& p) {
  p.ClearFun();
  p.ClearConst();
  for (const auto& [name, function] : functions) p.DefineFun(name, function, true);
  p.DefineFun("atan2", static_cast<double (*)(double, double)>(std::atan2), true);
  p.DefineFun("min", least, true);
  p.DefineFun("max", largest, true);
  p.DefineConst("pi", std::numbers::pi);
}

bool is_name(const std::string& text) {
  if (text.empty() || !(std::isalpha(static_cast<unsigned char>(text.front())) || text.front() == '_')) return false;
  return std::all_of(text.begin(), text.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; });
}

bool is_function(const std::string& name) {
  return std::any_of(std::begin(functions), std::end(functions), [&](const auto& f) { return name == f.first; }) ||
         std::find(more_names.begin(), more_names.end(), name) != more_names.end();
}

// What people write as other languages have it; else where reading stopped.
std::string what_is_wrong(const std::string& text, int position) {
  if (text.find("**") != std::string::npos) return "powers are written a^2";
  const auto at = static_cast<std::size_t>(std::max(position, 0));
  if (at >= text.size()) return "it ends too early";
  const bool after_number = at > 0 && std::isdigit(static_cast<unsigned char>(text[at - 1])) != 0;
  if (after_number && (std::isalpha(static_cast<unsigned char>(text[at])) != 0 || text[at] == '(')) return "products are written 2*a";
  return fmt::format("'{}' was not expected there", shown(text.substr(at, 20)));
}

}  // namespace

std::optional<Formulas::Fault> Formulas::add(const std::string& name, double value, std::optional<Dimension> dimension) {
  if (!is_name(name)) return Fault{fmt::format("'{}' is no name: letters, digits and '_' were expected", shown(name))};
  if (is_function(name)) return Fault{fmt::format("'{}' is a function: another name was expected", name)};
  if (std::any_of(parameters_.begin(), parameters_.end(), [&](const Parameter& p) { return p.key == name; }))
    return Fault{fmt::format("'{}' is given twice", name)};
  parameters_.push_back({name, dimension, value});
  return std::nullopt;
}

Formulas::Value Formulas::evaluate(const std::string& text) const {
  constexpr std::size_t longest = 1000;
  if (text.size() > longest) return {0, Fault{fmt::format("the formula is longer than {} characters", longest)}};
  for (const char c : text) {
    if (std::string_view("=<>&|?:!{}\"';").find(c) != std::string_view::npos)
      return {0, Fault{fmt::format(
                     "'{}' has no place in a formula: numbers, parameters, + - * / ^, parentheses and functions were expected", c)}};
  }
  try {
    mu::Parser p;
    define_functions(p);
    for (const Parameter& parameter : parameters_) p.DefineConst(parameter.key, parameter.value);
    p.SetExpr(text);
    int count = 0;
    const double* values = p.Eval(count);
    if (count != 1) return {0, Fault{"holds a comma, and is more than one number: decimals have a point"}};
    if (std::isnan(values[0])) return {0, Fault{"is no real number"}};
    if (std::isinf(values[0])) return {0, Fault{"is infinite"}};
    return {values[0], std::nullopt};
  } catch (const mu::ParserError& e) {
    std::string known;
    for (const Parameter& parameter : parameters_) known += (known.empty() ? "" : ", ") + parameter.key;
    if (e.GetCode() == mu::ecUNASSIGNABLE_TOKEN || e.GetCode() == mu::ecINVALID_NAME)
      return {0, Fault{fmt::format("'{}' is no parameter{}", shown(e.GetToken()),
                                   known.empty() ? "; [parameters] are none" : ": there are " + known)}};
    return {0, Fault{"is no formula: " + what_is_wrong(text, e.GetPos())}};
  }
}

}  // namespace gyromode::io
