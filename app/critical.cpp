#include "errors.h"
#include "job.h"
#include "parameter_axis.h"
#include "sensitivity.h"
#include "verbs.h"

#include "gyromode/base/number.h"

#include <fmt/format.h>

#include <memory>

namespace gyromode::app {

namespace {

struct Options {
  ModelSource source;
  WindowOption window;
  OutputOption output;
  std::string order = "1";
  std::optional<Index> lowest;
  std::string over;
  SensitivityOption sensitivity;
};

ExitCode run_over(const Options& o, const CriticalOptions& options, Job& job) {
  const ParameterAxis axis = axis_of(job.model(), taken_apart("--over", o.over, "bearing[*].kxx=1e5:1e8:31"), Spacing::logarithmic);
  const CriticalMap map =
      job.answer([&](const Model& m, const Progress& progress) { return m.critical_speeds_over(axis, options, progress); });
  o.output.write(document(job.model(), map, job.timings(), o.output.layout()));
  if (map.interrupted) return job.interrupted();
  if (!map.has_a_model()) throw LawBroken(fmt::format("--over: no value makes a model; at the first {}", map.rows.front().reason));
  if (map.is_complete()) return ExitCode::done;
  o.output.say("not certified complete at every value");
  return ExitCode::not_certified;
}

ExitCode run(const Options& given) {
  Options o = given;
  o.output.pictures = !o.over.empty();
  CriticalOptions options;
  const Parsed order = parse_real(o.order);
  if (order.outcome != Parsed::ok || !(order.value >= 0))
    throw UsageError(fmt::format("--order {}: a multiple of the speed was expected, such as 1, 2 or 0.5", o.order));
  constexpr double least = 1e-6, most = 1e6;
  if (order.value != 0 && !(order.value >= least && order.value <= most))
    throw UsageError(fmt::format("--order {}: 0, or from {:g} to {:g}, was expected", o.order, least, most));
  options.order = order.value;
  options.window = o.window.read();
  options.lowest = o.lowest;
  Job job(o.source, o.output);
  if (!o.over.empty()) return run_over(o, options, job);
  std::vector<Sensitivity> sensitivities;
  const CriticalSpeeds result = job.answer([&](const Model& m) {
    CriticalSpeeds found = m.critical_speeds(options);
    sensitivities = o.sensitivity.of(m, found);
    return found;
  });
  o.output.write(document(job.model(), result, job.timings(), o.output.layout(), sensitivities));
  if (result.coverage.status == CoverageStatus::complete) return ExitCode::done;
  o.output.say(fmt::format("not certified complete: {}", result.coverage.reason));
  return ExitCode::not_certified;
}

}  // namespace

void add_critical(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand(
      "critical", "Critical speeds: where a mode has a multiple of the speed as its frequency, all of a range, without a sweep");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  verb->add_option("--order", o->order,
                   "The multiple m of an excitation mΩ in fixed axes, also of a model in turning ones: 1 is unbalance, 0 weight")
      ->type_name("M")
      ->capture_default_str();
  auto* lowest = verb->add_option("--lowest", o->lowest, "Only the N lowest")->type_name("N")->check(whole_above_zero());
  o->window.add_to(*verb);
  for (const char* name : {"--below", "--window"}) lowest->excludes(verb->get_option(name));
  verb->add_option("--over", o->over,
                   "Over N values from A to B of a number of the model, spaced logarithmically: the undamped critical-speed map. Commas "
                   "between keys that share the value")
      ->type_name("KEY,…=A:B:N");
  o->sensitivity.add_to(*verb);
  verb->get_option("--sensitivity")->excludes(verb->get_option("--over"));
  o->output.add_to(*verb);
  verb->footer(
      "Examples:\n  gyromode critical models/rotors/two_discs.toml --lowest 6\n"
      "  gyromode critical models/rotors/overhung_disc.toml --below 20000rpm --format json\n"
      "  gyromode critical models/rotors/two_discs.toml --order 0.5 --below 6000rpm\n"
      "  gyromode critical models/turned_rotor.toml --order 0\n"
      "  gyromode critical models/rotors/two_discs.toml --over 'bearing[*].kxx,bearing[*].kyy=1e5:1e9:9' --below 20000rpm");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
