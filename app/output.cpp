#include "output.h"

#include "errors.h"

#include "gyromode/base/error.h"
#include "gyromode/formats/write_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>

namespace gyromode::app {

void OutputOption::add_to(CLI::App& verb) {
  verb.add_option("--format", format,
                  "table, json, csv, markdown, html (a page of its own, with pictures that move), or svg (a picture: of modes, campbell, "
                  "critical --over, stability --vary, response); "
                  "default: by the extension of -o, "
                  "else table")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"table", "json", "csv", "markdown", "html", "svg"}));
  verb.add_option("-o,--output", file, "Write the result to FILE (.json, .csv, .md, .html, .svg by extension) instead of stdout")
      ->type_name("FILE");
  verb.add_option(
          "--units", units,
          "Frequencies and spins in tables, CSV and pictures in this unit; default: that of --below, --window, --spin …, else rad/s. "
          "JSON stays in rad/s")
      ->type_name("U")
      ->check(CLI::IsMember({"rad/s", "Hz", "rpm"}));
  verb_ = &verb;
  auto* silent = verb.add_flag("--quiet", quiet, "No remarks on stderr; errors remain");
  verb.add_flag("--verbose", verbose, "On stderr how long each stage took, and the numbers that the verdict rests on")->excludes(silent);
}

Format OutputOption::chosen(Format otherwise) const {
  if (!pictures && (format == "svg" || (format.empty() && format_for(file) == Format::svg)))
    throw UsageError(
        "svg is a picture of the modes of a rotor or spacecraft (gyromode modes MODEL -o shapes.svg), of campbell, critical --over, "
        "stability --vary or response: there is none here");
  if (!format.empty()) return *format_named(format);
  if (file.empty()) return otherwise;
  return format_for(file);
}

namespace {

// The unit that a value of an option has its frequencies in: "0:12000rpm:25".
std::optional<FrequencyUnit> unit_in(const std::string& value) {
  std::size_t first = 0;
  while (first <= value.size()) {
    const std::size_t past = std::min(value.find_first_of(":=", first), value.size());
    if (const auto unit = frequency_unit_of(value.substr(first, past - first))) return unit;
    first = past + 1;
  }
  return std::nullopt;
}

}  // namespace

Layout OutputOption::layout(Format otherwise) const {
  Layout l(chosen(otherwise));
  std::optional<FrequencyUnit> of_spins, of_frequencies;
  for (const CLI::Option* option : verb_->get_options()) {
    if (option->count() == 0 || option->get_lnames().empty()) continue;
    const std::string& name = option->get_lnames().front();
    if (name == "format" || name == "output" || name == "quiet" || name == "verbose" || name == "units") continue;
    std::string all;
    for (const std::string& value : option->results()) all += (all.empty() ? "" : ",") + value;
    l.options.emplace_back(name, all);
    std::optional<FrequencyUnit>& unit = name == "spin" ? of_spins : of_frequencies;
    for (const std::string& value : option->results()) {
      if (!unit) unit = unit_in(value);
    }
  }
  if (const auto asked = frequency_unit_named(units)) of_spins = of_frequencies = asked;
  l.unit = of_frequencies ? *of_frequencies : of_spins.value_or(FrequencyUnit::radians);
  l.spin_unit = of_spins ? *of_spins : l.unit;
  return l;
}

void OutputOption::require_place(const std::vector<std::string>& inputs) const {
  if (file.empty()) return;
  const std::string extension = std::filesystem::path(file).extension().string();
  constexpr std::string_view known[] = {"", ".json", ".csv", ".md", ".html", ".htm", ".svg", ".txt", ".out", ".log"};
  if (format.empty() && std::find(std::begin(known), std::end(known), extension) == std::end(known))
    throw UsageError(
        fmt::format("-o {}: '{}' is no format that is written: .json, .csv, .md, .html, .svg or .txt (a table) was expected, or --format",
                    file, extension));
  for (const std::string& input : inputs) {
    std::error_code error;
    if (!input.empty() && std::filesystem::equivalent(file, input, error) && !error)
      throw UsageError(fmt::format("-o {} would overwrite the input: another file was expected", file));
  }
}

void OutputOption::write(const std::string& text) const {
  if (!file.empty()) {
    io::write_file(file, text);
    return;
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (std::fflush(stdout) != 0) throw Unreadable("stdout", "the result could not be written");
}

void OutputOption::say(const std::string& line) const {
  if (!quiet) fmt::print(stderr, "gyromode: {}\n", line);
}

}  // namespace gyromode::app
