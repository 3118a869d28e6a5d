#include "errors.h"
#include "job.h"
#include "parameter_axis.h"
#include "verbs.h"

#include "gyromode/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace gyromode::app {

namespace {

struct Options {
  ModelSource source;
  OutputOption output;
  std::vector<std::string> vary;
};

std::vector<AxisText> axes_of(const std::vector<std::string>& vary) {
  constexpr std::int64_t most_cells = 1000000;  // verdicts of some milliseconds: an hour or more
  std::vector<AxisText> axes;
  for (const std::string& text : vary) axes.push_back(taken_apart("--vary", text, "spin=5rpm:20rpm:31"));
  if (axes.size() == 2 && axes[0].keys == axes[1].keys) throw UsageError(fmt::format("--vary: '{}' is given twice", axes[0].keys));
  if (axes.size() > 2) throw UsageError("--vary: one parameter, or two for a chart");
  if (axes.size() == 2 && axes[0].values * axes[1].values > most_cells) {
    throw UsageError(fmt::format("--vary: {} × {} = {} cells are more than the {} that a map may have: ask for fewer values",
                                 axes[0].values, axes[1].values, axes[0].values * axes[1].values, most_cells));
  }
  return axes;
}

StabilityReport asked(const Model& model, const std::vector<AxisText>& texts, const Progress& progress) {
  std::vector<ParameterAxis> axes;
  for (const AxisText& text : texts) axes.push_back(axis_of(model, text));
  StabilityReport report = model.stability(progress);
  for (const ParameterAxis& axis : axes) report.varied.push_back(axis.keys);
  if (!axes.empty()) report.map = model.stability_over(axes, progress);
  return report;
}

// A map of nothing is no answer.
void require_models(const StabilityMap& map) {
  if (std::any_of(map.cells.begin(), map.cells.end(), [](const StabilityMap::Cell& c) { return c.point.law_kept; })) return;
  throw LawBroken(fmt::format("--vary: no point makes a model; at the first {}", map.cells.front().point.reason));
}

ExitCode run(const Options& given) {
  Options o = given;
  o.output.pictures = !o.vary.empty();
  const std::vector<AxisText> axes = axes_of(o.vary);
  Job job(o.source, o.output);
  const StabilityReport report = job.answer([&](const Model& m, const Progress& p) { return asked(m, axes, p); });
  o.output.write(document(job.model(), report, job.timings(), o.output.layout()));
  if (o.output.verbose) {
    for (const std::string& line : evidence(report.result)) o.output.say(line);
  }
  if (report.map && report.map->interrupted) return job.interrupted();
  if (report.map) require_models(*report.map);
  if (report.result.stability != Stability::unknown) return ExitCode::done;
  o.output.say(fmt::format("the verdict is unknown: {}", report.result.coverage.reason));
  return ExitCode::not_certified;
}

}  // namespace

void add_stability(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand(
      "stability",
      "Stability verdict with its proof: the index balance, negative-energy modes, growth rates, margins; mapped over parameters");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  verb->add_option("--vary", o->vary,
                   "Also the verdict at N values from A to B of a number of the model file, and the critical values between; twice: a "
                   "chart. KEY is its dotted path, arrays from 0, [*] for all items; "
                   "SI, or each bound with its own unit")
      ->type_name("KEY=A:B:N")
      ->take_all();
  o->output.add_to(*verb);
  verb->footer(
      "Examples:\n  gyromode stability models/three_springs.toml\n  gyromode stability models/rigid_body.toml --format json\n"
      "  gyromode stability models/three_springs.toml --vary spin=0:12000rpm:25\n"
      "  gyromode stability models/geos.toml --vary 'cable[*].length=5:40:8'\n"
      "  gyromode stability models/mms.toml --vary body.inertia[2]=500:3000:6 --format json");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
