#include "output.h"

#include "errors.h"

#include "gyromode/base/error.h"
#include "gyromode/formats/write_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <system_error>

namespace gyromode::app {

void OutputOption::add_to(CLI::App& verb) {
  verb.add_option("--format", format,
                  "table, json, csv, markdown, or svg (mode shapes of a spacecraft); default: by the extension of -o, else table")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"table", "json", "csv", "markdown", "svg"}));
  verb.add_option("-o,--output", file, "Write the result to FILE (.json, .csv, .md, .svg by extension) instead of stdout")
      ->type_name("FILE");
  auto* silent = verb.add_flag("--quiet", quiet, "No remarks on stderr; errors remain");
  verb.add_flag("--verbose", verbose, "On stderr how long each stage took, and the numbers that the verdict rests on")->excludes(silent);
}

Format OutputOption::chosen(Format otherwise) const {
  if (!pictures && (format == "svg" || (format.empty() && format_for(file) == Format::svg)))
    throw UsageError("svg is for the mode shapes of a spacecraft: gyromode modes MODEL -o shapes.svg");
  if (!format.empty()) return *format_named(format);
  if (file.empty()) return otherwise;
  return format_for(file);
}

void OutputOption::require_place(const std::vector<std::string>& inputs) const {
  if (file.empty()) return;
  const std::string extension = std::filesystem::path(file).extension().string();
  constexpr std::string_view known[] = {"", ".json", ".csv", ".md", ".svg", ".txt", ".out", ".log"};
  if (format.empty() && std::find(std::begin(known), std::end(known), extension) == std::end(known))
    throw UsageError(fmt::format(
        "-o {}: '{}' is no format that is written: .json, .csv, .md, .svg or .txt (a table) was expected, or --format", file, extension));
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
