// Times the dense solvers against LAPACK, interleaved; bench/README.md says what each row is and how to read it.

#include "report.h"

#include "gyromode/lapack/memory.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>

namespace {

using namespace gyromode::bench;

struct Group {
  const char* key;
  std::function<std::vector<Row>(const RowOptions&)> run;
};

const std::vector<Group> groups = {
    {"a", quadrature_rows}, {"b", general_rows},    {"c", indefinite_rows}, {"d", certificate_rows},
    {"e", process_rows},    {"f", spacecraft_rows}, {"g", hidden_rows},     {"h", certified_rows},
    {"i", growth_rows},     {"j", sweep_rows},      {"k", campbell_rows},
};

void print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

void run(Report& report, const std::vector<std::string>& only) {
  const auto wanted = [&](const std::string& key) { return only.empty() || std::find(only.begin(), only.end(), key) != only.end(); };
  print(text(report.machine, report.revision));
  for (const Group& group : groups) {
    if (!wanted(group.key)) continue;
    for (Row& row : group.run(report.options)) {
      print(text(row));
      report.rows.push_back(std::move(row));
    }
  }
  if (!wanted("accuracy")) return;
  report.accuracy = accuracy_league(report.options);
  print(text(report.accuracy));
}

void write(const Report& report, const std::string& path) {
  std::ofstream file(path);
  file << json(report).dump(1) << '\n';
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
}

}  // namespace

int main(int argc, char** argv) {
  Report report;
  report.revision = "unknown";
  std::vector<std::string> only;
  std::string json_file;
  CLI::App app{"Ratios of medians of gyromode's dense solvers to LAPACK's drivers, interleaved in one run.", "gyromode_bench"};
  app.add_option("--n-scale", report.options.n_scale, "multiplies every order")->check(CLI::PositiveNumber);
  app.add_option("--repetitions", report.options.rounds, "timed rounds after one to warm up")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--process-repetitions", report.options.process_rounds, "the same for row e")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--only", only, "rows to run: a, b, c, d, e, f, g, h, i, j, accuracy")
      ->delimiter(',')
      ->check(CLI::IsMember({"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "accuracy"}));
  app.add_option("--json", json_file, "write everything to this file");
  app.add_option("--program", report.options.program, "the program of row e")->capture_default_str();
  app.add_option("--model", report.options.model, "the model of row e")->capture_default_str();
  app.add_option("--revision", report.revision, "git revision to record");
  bool default_memory = false;
  app.add_flag("--default-memory", default_memory,
               "let the C library give freed memory back, as it does where nobody calls keep_freed_memory()");
  CLI11_PARSE(app, argc, argv);
  if (!default_memory) gyromode::lapack::keep_freed_memory();
  try {
    report.machine = this_machine();
    run(report, only);
    if (!json_file.empty()) write(report, json_file);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "gyromode_bench: %s\n", e.what());
    return 1;
  }
  return 0;
}
