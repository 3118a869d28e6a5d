#include "errors.h"
#include "output.h"
#include "verbs.h"

#include "gyromode/base/error.h"
#include "gyromode/formats/text_file.h"
#include "gyromode/html/report_page.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace gyromode::app {

namespace {

struct Options {
  std::vector<std::string> results;
  OutputOption output;
};

std::string content_of(const std::string& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw Unreadable(file, "a folder: a result as JSON was expected (gyromode … -o result.json)");
  if (!std::filesystem::exists(file, error))
    throw Unreadable(file, "no such file, or it cannot be read: a result as JSON was expected (gyromode … -o result.json)");
  return io::read_bytes(file, "JSON");
}

ExitCode run(const Options& o) {
  const std::string extension = std::filesystem::path(o.output.file).extension().string();
  if (!o.output.file.empty() && extension != ".html" && extension != ".htm")
    throw UsageError(fmt::format("-o {}: a report is a page of HTML: a name that ends in .html was expected", o.output.file));
  o.output.require_place(o.results);
  std::vector<ReportDocument> documents;
  for (const std::string& file : o.results) documents.push_back({file, content_of(file)});
  o.output.write(report_page(documents));
  return ExitCode::done;
}

}  // namespace

void add_report(CLI::App& program, int& code) {
  CLI::App* verb =
      program.add_subcommand("report", "Results as one page of HTML that fetches nothing: tables, certificates, charts, modes that move");
  auto o = std::make_shared<Options>();
  verb->add_option("results", o->results, "Results as JSON (gyromode … -o RESULT.json), of any verbs and models")
      ->type_name("RESULT")
      ->required();
  verb->add_option("-o,--output", o->output.file, "The page, .html; default: stdout")->type_name("FILE");
  verb->footer(
      "Any verb makes the page of its own result with -o x.html.\nExamples:\n  gyromode modes models/geos.toml --lowest 12 -o geos.html\n"
      "  gyromode campbell models/rotors/two_discs.toml --spin 0:12000rpm:25 --lowest 6 -o campbell.json\n"
      "  gyromode report campbell.json -o report.html");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
