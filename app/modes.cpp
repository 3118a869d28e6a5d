#include "errors.h"
#include "job.h"
#include "load.h"
#include "sensitivity.h"
#include "verbs.h"

#include "gyromode/base/error.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/base/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace gyromode::app {

namespace {

struct Options {
  ModelSource source;
  WindowOption window;
  OutputOption output;
  std::optional<Index> lowest;
  bool all = false;
  bool dry_run = false;
  bool shapes = false;
  bool participation = false;
  std::string method = "auto";
  std::optional<Index> elements;
  std::string keep;
  int schema = 1;
  SensitivityOption sensitivity;
};

// Of a spacecraft, which has infinitely many modes, and of a large sparse model, how many of them.
void bound(ModesOptions& options, const Options& o, bool transcendental) {
  const char* why =
      transcendental ? "a spacecraft with exact booms has infinitely many modes" : "a large sparse model is searched window by window";
  if (o.all) throw UsageError(fmt::format("--all: {}; give --below W, --window A:B or --lowest N", why));
  if (options.lowest) return;
  if (!o.window.given())
    options.lowest = lowest_by_default;
  else if (options.window.open())
    throw UsageError(fmt::format("--window: {}; the upper end is needed", why));
}

// What the work would take: factorisations of a large model, one at a time but for the first two; a dense one by its
// order.
ExitCode estimate(const Model& model, const OutputOption& output) {
  constexpr double bytes_an_entry = 60, megabyte = 1e6;
  const std::vector<PlannedFactorisation> plan = model.body->plan();
  const auto n = static_cast<double>(model.size());
  std::string text;
  if (plan.empty())
    text = fmt::format("dense: {} coordinates, some {:.0f} MB\n", model.size(), std::max(1.0, bytes_an_entry * n * n / megabyte));
  for (const PlannedFactorisation& p : plan)
    text += fmt::format("{:<18} order {:>8}  {:>8.3g} entries in the factor  {:>7.0f} MB, or {:.0f} MB with {:.0f} MB in files\n", p.what,
                        p.order, p.entries, p.megabytes, p.megabytes_beside_files, p.megabytes_in_files);
  output.write(text);
  return ExitCode::done;
}

ExitCode run(const Options& given) {
  Options o = given;
  Job job(o.source, o.output);
  if (o.elements && o.method != "discrete") throw UsageError("--elements belongs to --method discrete of a spacecraft model");
  ModesOptions options;
  options.window = o.window.read();
  options.lowest = o.lowest;
  options.method = method_named(o.method).value_or(Method::automatic);
  if (!o.keep.empty()) options.keep = labels_of(o.keep, job.model().labels());
  if (o.method == "discrete") job.replace(job.model().body->discretised(o.elements));
  const bool infinite = !job.model().body->finite();
  if (infinite) bound(options, o, job.model().body->transcendental());
  if (o.dry_run) return estimate(job.model(), o.output);
  o.output.pictures = job.model().body->has_outlines();
  const Format format = o.output.chosen();
  const bool parts = !job.model().body->orbits().empty();  // whirl and parts belong in the table
  const bool drawn = format == Format::svg || format == Format::html;
  options.shapes = o.shapes || drawn || o.sensitivity.asked || o.participation || parts;
  ModeDetails details;
  ModesResult result = job.answer([&](const Model& m, const Progress& progress) {
    options.progress = progress;
    ModesResult found = m.modes(options);
    if (o.sensitivity.asked && !found.coverage.interrupted) progress.stage("sensitivities");
    if (o.participation || parts || format == Format::html) details = details_of(m, found);
    if (!found.coverage.interrupted) details.sensitivities = o.sensitivity.of(m, found.modes);
    return found;
  });
  if (!o.shapes && !drawn) result.drop_shapes();
  o.output.write(document(job.model(), result, job.timings(), o.output.layout(), o.schema, details));
  if (o.output.verbose) {
    for (const std::string& line : evidence(result)) o.output.say(line);
  }
  for (const std::string& doubt : job.model().doubts(result)) o.output.say("remark: " + doubt);
  for (const std::string& remark : result.remarks(o.lowest)) o.output.say(remark);
  if (result.coverage.interrupted) return job.interrupted();
  if (result.is_complete()) return ExitCode::done;
  o.output.say(fmt::format("not certified complete: {}", result.coverage.reason));
  return ExitCode::not_certified;
}

}  // namespace

void add_modes(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand(
      "modes", "All modes of a model, or those of a window: frequencies, energy signs, shapes, verdict, certificate");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  auto* lowest =
      verb->add_option("--lowest", o->lowest, "Only the N lowest that are not rigid-body modes")->type_name("N")->check(whole_above_zero());
  auto* all = verb->add_flag("--all", o->all,
                             "All modes (the default for matrices; a spacecraft has infinitely many, and its default is --lowest 10)");
  o->window.add_to(*verb);
  for (const char* name : {"--below", "--window"}) {
    lowest->excludes(verb->get_option(name));
    all->excludes(verb->get_option(name));
  }
  all->excludes(lowest);
  verb->add_option("--method", o->method,
                   "Matrices: auto, quadrature, hidden (a symmetry found in any coordinates), general, first-order, symmetric-2n (the two "
                   "classical 2n methods); spacecraft: exact, or discrete (finite elements, to compare)")
      ->type_name("NAME")
      ->check(CLI::IsMember({"auto", "quadrature", "hidden", "general", "first-order", "symmetric-2n", "exact", "discrete"}))
      ->capture_default_str();
  verb->add_option("--elements", o->elements, "Linear elements a cable of --method discrete (default 50)")
      ->type_name("N")
      ->check(CLI::Range(1, 2000));
  verb->add_option("--keep", o->keep,
                   "Matrices: see the modes from these coordinates alone, LABEL,LABEL,… (a label with a comma in double quotes, or #N for "
                   "its position); modes in which they take no part are local")
      ->type_name("LABELS");
  verb->add_flag("--dry-run", o->dry_run, "Read the model and say what its factorisations would take, in memory; solve nothing");
  verb->add_flag("--shapes", o->shapes, "With the mode shapes: motion is Re(X e^{jωt}), largest entry 1");
  verb->add_flag("--participation", o->participation,
                 "Where the energy of each mode is: shares of kinetic and strain energy by parts of a rotor or spacecraft (in the table "
                 "without it), by coordinates of matrices");
  verb->add_option("--schema", o->schema, "Version of the JSON schema: 1, a shape with each mode (default); 2, all shapes as one block")
      ->type_name("VERSION")
      ->check(CLI::IsMember({1, 2}));
  o->sensitivity.add_to(*verb);
  o->output.add_to(*verb);
  verb->footer(
      "Examples:\n  gyromode modes models/three_springs.toml --shapes\n  gyromode modes models/wiresaw.toml --lowest 3 --format json\n"
      "  gyromode modes models/geos.toml --below 40rpm\n  gyromode modes models/rotors/two_discs.toml --lowest 4 --sensitivity\n  gyromode "
      "modes models/geos.toml --lowest 6 -o shapes.svg\n  gyromode modes "
      "models/geos.toml --method discrete --elements 100\n"
      "  gyromode modes --mass M.mtx --gyroscopic G.mtx --stiffness K.mtx --window 1Hz:50Hz -o modes.csv");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
