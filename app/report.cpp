#include "errors.h"
#include "verbs.h"

#include "gyromode/base/error.h"
#include "gyromode/formats/write_file.h"
#include "gyromode/html/report_page.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace gyromode::app {

namespace {

struct Options {
  std::vector<std::string> results;
  std::string file;
};

std::string content_of(const std::string& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw Unreadable(file, "a folder: a result as JSON was expected (gyromode … -o result.json)");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Unreadable(file, "no such file, or it cannot be read: a result as JSON was expected (gyromode … -o result.json)");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void require_place(const Options& o) {
  if (o.file.empty()) return;
  const std::string extension = std::filesystem::path(o.file).extension().string();
  if (extension != ".html" && extension != ".htm")
    throw UsageError(fmt::format("-o {}: a report is a page of HTML: a name that ends in .html was expected", o.file));
  for (const std::string& input : o.results) {
    std::error_code error;
    if (std::filesystem::equivalent(o.file, input, error) && !error)
      throw UsageError(fmt::format("-o {} would overwrite the input: another file was expected", o.file));
  }
}

ExitCode run(const Options& o) {
  require_place(o);
  std::vector<ReportDocument> documents;
  for (const std::string& file : o.results) documents.push_back({file, content_of(file)});
  const std::string page = report_page(documents);
  if (!o.file.empty()) {
    io::write_file(o.file, page);
    return ExitCode::done;
  }
  std::fwrite(page.data(), 1, page.size(), stdout);
  if (std::fflush(stdout) != 0) throw Unreadable("stdout", "the report could not be written");
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
  verb->add_option("-o,--output", o->file, "The page, .html; default: stdout")->type_name("FILE");
  verb->footer(
      "Any verb makes the page of its own result with -o x.html.\nExamples:\n  gyromode modes models/geos.toml --lowest 12 -o geos.html\n"
      "  gyromode campbell models/rotors/two_discs.toml --spin 0:12000rpm:25 --lowest 6 -o campbell.json\n"
      "  gyromode report campbell.json -o report.html");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
