#include "gyromode/html/report_page.h"

#include "gyromode/base/error.h"
#include "gyromode/base/nearest.h"
#include "gyromode/html/embedded_page.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace gyromode {

namespace {

using Json = nlohmann::ordered_json;

// What the page reads of each kind without asking whether it is there.
struct Kind {
  std::string_view name;
  int newest;  // version
  std::vector<std::string_view> objects, arrays;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {"modes", 2, {"structure", "index_balance", "coverage"}, {"modes", "unstable"}},
      {"count", 1, {}, {"window", "negative"}},
      {"structure", 1, {"structure"}, {"components"}},
      {"stability", 1, {"index_balance"}, {"unstable"}},
      {"critical", 1, {}, {}},
      {"campbell", 1, {}, {"spins", "branches", "coverage", "stability", "events", "excitation"}},
      {"response", 1, {}, {"labels", "t", "q"}},
      {"frequency_response", 1, {}, {"labels", "points"}},
      {"unbalance_response", 1, {}, {"labels", "points"}},
  };
  return all;
}

std::string all_kinds() {
  std::string words;
  for (const Kind& k : kinds()) words += fmt::format("{}{}", words.empty() ? "" : ", ", k.name);
  return words;
}

Json parsed(const ReportDocument& d) {
  try {
    return Json::parse(d.json);
  } catch (const Json::parse_error& e) {
    const std::string_view before(d.json.data(), std::min(e.byte, d.json.size()));
    const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
    throw Unreadable(d.name, line, 0, "not JSON, or cut off: a result was expected, as gyromode … -o result.json writes it");
  }
}

const Kind& kind_of(const std::string& name, const Json& json) {
  const auto schema = json.is_object() ? json.find("schema") : json.end();
  if (!json.is_object() || schema == json.end() || !schema->is_string())
    throw Unreadable(name, "JSON, but no result of gyromode: it has no \"schema\"");
  const std::string given = schema->get<std::string>();
  constexpr std::string_view ours = "gyromode/";
  const std::size_t slash = given.rfind('/');
  if (given.rfind(ours, 0) != 0 || slash < ours.size())
    throw Unreadable(name, fmt::format("schema '{:.60}' is not one of gyromode: gyromode/KIND/VERSION was expected", given));
  const std::string kind = given.substr(ours.size(), slash - ours.size()), version = given.substr(slash + 1);
  const auto known = std::find_if(kinds().begin(), kinds().end(), [&](const Kind& k) { return k.name == kind; });
  if (known == kinds().end()) {
    std::vector<std::string_view> names;
    for (const Kind& k : kinds()) names.push_back(k.name);
    throw Unreadable(
        name, fmt::format("a document of kind '{:.60}' is not known{}: {} were expected", kind, suggestion(kind, names), all_kinds()));
  }
  for (int v = 1; v <= known->newest; ++v) {
    if (version == std::to_string(v)) return *known;
  }
  throw Unreadable(name,
                   fmt::format("version '{:.20}' of {} is not known to this program: {} was expected; a newer gyromode may have written it",
                               version, kind, known->newest == 1 ? "1" : fmt::format("1 to {}", known->newest)));
}

void require(const std::string& name, const Json& json, const Kind& kind) {
  const auto missing = [&](std::string_view key, const char* what) {
    throw Unreadable(name, fmt::format("damaged: a document of kind '{}' has \"{}\", {}", kind.name, key, what));
  };
  const auto of = [&](std::string_view key) { return json.find(std::string(key)); };
  if (of("model") == json.end() || !of("model")->is_object() || !of("model")->value("title", Json()).is_string())
    missing("model", "an object with a title");
  for (const std::string_view key : kind.objects) {
    if (of(key) == json.end() || !of(key)->is_object()) missing(key, "an object");
  }
  for (const std::string_view key : kind.arrays) {
    if (of(key) == json.end() || !of(key)->is_array()) missing(key, "a list");
  }
}

// In a script element nothing ends it but "</script": "<" is written as an escape of JSON.
std::string within_script(const std::string& json) {
  std::string safe;
  for (const char c : json) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

}  // namespace

std::string report_page(const std::vector<ReportDocument>& documents) {
  Json all = Json::array();
  for (const ReportDocument& d : documents) {
    Json json = parsed(d);
    require(d.name, json, kind_of(d.name, json));
    all.push_back({{"name", d.name}, {"document", std::move(json)}});
  }
  constexpr std::string_view place = "{{documents}}";
  std::string page(embedded_page());
  const std::size_t at = page.find(place);
  page.replace(at, place.size(), within_script(all.dump(-1, ' ', false, Json::error_handler_t::replace)));
  return page;
}

}  // namespace gyromode
