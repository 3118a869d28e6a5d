#include "errors.h"
#include "job.h"
#include "verbs.h"

#include "gyromode/base/error.h"
#include "gyromode/io/nearest.h"
#include "gyromode/base/number.h"
#include "gyromode/modes/discrete.h"
#include "gyromode/modes/keep.h"
#include "gyromode/modes/modes.h"
#include "gyromode/modes/spacecraft.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>

namespace gyromode::app {

namespace {

struct Options {
  ModelSource source;
  WindowOption window;
  OutputOption output;
  std::optional<Index> lowest;
  bool all = false;
  bool shapes = false;
  std::string method = "auto";
  std::optional<Index> elements;
  std::string keep;
};

constexpr Index lowest_of_a_spacecraft = 10;

dense::Method method_named(const std::string& name, bool spacecraft) {
  if (name == "auto" || (spacecraft && (name == "exact" || name == "discrete"))) return dense::Method::automatic;
  if (name == "quadrature") return dense::Method::quadrature;
  if (name == "hidden") return dense::Method::hidden;
  if (name == "general") return dense::Method::general;
  if (name == "first-order") return dense::Method::first_order;
  if (name == "symmetric-2n") return dense::Method::symmetric_2n;
  throw NotApplicable(fmt::format("method '{}' serves spacecraft models with continuum booms, and this is a matrix model; 'auto', 'quadrature', 'hidden', 'general', "
                                              "'first-order' or 'symmetric-2n' apply", name));
}

// The positions of comma-separated labels.
std::vector<Index> kept_coordinates(const std::string& list, const Labels& labels) {
  std::vector<Index> kept;
  const std::vector<std::string_view> known(labels.begin(), labels.end());
  std::istringstream words(list);
  for (std::string label; std::getline(words, label, ',');) {
    const auto at = std::find(labels.begin(), labels.end(), label);
    if (at == labels.end()) throw UsageError(fmt::format("--keep: '{}' is no coordinate of the model: did you mean '{}'?", label, io::nearest(label, known)));
    const Index i = at - labels.begin();
    if (std::find(kept.begin(), kept.end(), i) != kept.end()) throw UsageError(fmt::format("--keep: '{}' is given twice", label));
    kept.push_back(i);
  }
  return kept;
}

ModesResult solved(Job& job, const Options& o, ModesOptions options) {
  const auto* craft = std::get_if<Spacecraft>(&job.model().system);
  options.method = method_named(o.method, craft != nullptr);
  if (!craft) {
    if (o.elements) throw UsageError("--elements belongs to --method discrete of a spacecraft model");
    if (!o.keep.empty()) {
      const auto* system = std::get_if<System>(&job.model().system);
      if (!system) throw NotApplicable("--keep condenses M, G, K of second order; this model is of first order");
      const std::vector<Index> kept = kept_coordinates(o.keep, system->labels());
      return job.solve([&](const auto&) { return find_modes_keeping(*system, kept, options); });
    }
    return job.solve([&](const auto& system) { return find_modes(system, options); });
  }
  if (!o.keep.empty()) throw NotApplicable("--keep condenses matrix models; a spacecraft with exact booms is condensed onto its body already");
  if (o.elements && o.method != "discrete") throw UsageError("--elements belongs to --method discrete");
  const bool infinite = o.method != "discrete" && !(craft->cables().empty() && craft->beams().empty());
  if (o.all && infinite) {
    throw UsageError("--all: a spacecraft with exact booms has infinitely many modes; give --below W, --window A:B or --lowest N");
  }
  if (!o.all && !o.window.given() && !options.lowest && infinite) options.lowest = lowest_of_a_spacecraft;
  if (options.window.open() && !options.lowest && infinite) throw UsageError("--window: a spacecraft with exact booms has infinitely many modes; the upper end is needed");
  if (o.method != "discrete") return job.solve([&](const auto& system) { return find_modes(system, options); });
  const Mesh mesh{o.elements.value_or(Mesh{}.elements), 1};
  const Spacecraft spacecraft = *craft;
  job.replace(discretise(spacecraft, mesh));
  return job.solve([&](const auto&) { return find_modes(spacecraft, mesh, options); });
}

ExitCode run(const Options& given) {
  Options o = given;
  Job job(o.source, o.output);
  o.output.pictures = std::holds_alternative<Spacecraft>(job.model().system) && o.method != "discrete";
  const io::Format format = o.output.chosen();
  o.shapes = o.shapes || format == io::Format::svg;
  ModesOptions options;
  options.window = o.window.read();
  options.lowest = o.lowest;
  options.shapes = o.shapes;
  const ModesResult result = solved(job, o, options);
  o.output.write(document(job.model(), result, job.timings(), format));
  const Coverage& c = result.coverage;
  if (c.window.a != c.requested.a || (c.window.b != c.requested.b && !c.requested.open())) {
    o.output.say(fmt::format("an end of the window falls on a mode: [{:.17g}, {:.17g}) rad/s was used", c.window.a, c.window.b));
  }
  if (o.lowest && static_cast<Index>(result.modes.size()) > *o.lowest) {
    Index vibrations = 0;
    for (const Mode& m : result.modes) vibrations += m.kind != ModeKind::rigid_body ? 1 : 0;
    if (vibrations > *o.lowest) o.output.say(fmt::format("mode {} coincides with the next: {} modes are listed", *o.lowest, vibrations));
  }
  if (c.status == CoverageStatus::complete) return ExitCode::done;
  o.output.say(fmt::format("not certified complete: {}", c.reason));
  return ExitCode::not_certified;
}

// Why the text is no whole number above 0; empty where it is one.
std::string above_zero(const std::string& text) {
  const auto n = whole_number(text);
  return n && *n > 0 ? "" : fmt::format("'{}' is no whole number above 0", text);
}

}  // namespace

void add_modes(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand("modes", "All modes of a model, or those of a window: frequencies, energy signs, shapes, verdict, certificate");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  auto* lowest = verb->add_option("--lowest", o->lowest, "Only the N lowest that are not rigid-body modes")->type_name("N")->check(CLI::Validator(above_zero, ""));
  auto* all = verb->add_flag("--all", o->all, "All modes (the default for matrices; a spacecraft has infinitely many, and its default is --lowest 10)");
  o->window.add_to(*verb);
  for (const char* name : {"--below", "--window"}) {
    lowest->excludes(verb->get_option(name));
    all->excludes(verb->get_option(name));
  }
  all->excludes(lowest);
  verb->add_option("--method", o->method, "Matrices: auto, quadrature, hidden (a symmetry found in any coordinates), general, first-order, symmetric-2n (the two classical 2n methods); spacecraft: exact, or discrete (finite elements, to compare)")
      ->type_name("NAME")
      ->check(CLI::IsMember({"auto", "quadrature", "hidden", "general", "first-order", "symmetric-2n", "exact", "discrete"}))
      ->capture_default_str();
  verb->add_option("--elements", o->elements, "Linear elements a cable of --method discrete (default 50)")->type_name("N")->check(CLI::Range(1, 2000));
  verb->add_option("--keep", o->keep, "Matrices: see the modes from these coordinates alone, LABEL,LABEL,…; modes in which they take no part are local")->type_name("LABELS");
  verb->add_flag("--shapes", o->shapes, "With the mode shapes: motion is Re(X e^{jωt}), largest entry 1");
  o->output.add_to(*verb);
  verb->footer("Examples:\n  gyromode modes models/three_springs.toml --shapes\n  gyromode modes models/wiresaw.toml --lowest 3 --format json\n"
                              "  gyromode modes models/geos.toml --below 40rpm\n  gyromode modes models/geos.toml --lowest 6 -o shapes.svg\n  gyromode modes models/geos.toml --method discrete --elements 100\n"
               "  gyromode modes --mass M.mtx --gyroscopic G.mtx --stiffness K.mtx --window 1Hz:50Hz -o modes.csv");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
