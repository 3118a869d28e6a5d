#include "errors.h"
#include "exit_code.h"
#include "job.h"
#include "verbs.h"

#include "gyromode/modes/modes.h"

#include <fmt/format.h>

#include <memory>

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
};

dense::Method method_named(const std::string& name) {
  if (name == "auto") return dense::Method::automatic;
  if (name == "quadrature") return dense::Method::quadrature;
  if (name == "general") return dense::Method::general;
  if (name == "first-order") return dense::Method::first_order;
  if (name == "symmetric-2n") return dense::Method::symmetric_2n;
  const bool boom = name == "exact" || name == "discrete";
  throw dense::MethodDoesNotApply(fmt::format("method '{}' {}; 'auto', 'quadrature', 'general', 'first-order' or 'symmetric-2n' apply", name,
                                              boom ? "serves spacecraft models with continuum booms, and this is a matrix model"
                                                   : "is not part of this version"));
}

int run(const Options& o) {
  Job job(o.source, o.output);
  ModesOptions options;
  options.method = method_named(o.method);
  options.window = o.window.read();
  options.lowest = o.lowest;
  options.shapes = o.shapes;
  options.structure = o.source.structure();
  const ModesResult result = job.solve([&](const auto& system) { return find_modes(system, options); });
  o.output.write(document(job.model(), result, job.timings(), o.output.chosen()));
  const Coverage& c = result.coverage;
  if (c.window.a != c.requested.a || (c.window.b != c.requested.b && !o.lowest)) {
    o.output.say(fmt::format("an end of the window falls on a mode: [{:.17g}, {:.17g}) rad/s was used", c.window.a, c.window.b));
  }
  if (o.lowest && static_cast<Index>(result.modes.size()) > *o.lowest) {
    Index vibrations = 0;
    for (const Mode& m : result.modes) vibrations += m.kind != ModeKind::rigid_body ? 1 : 0;
    if (vibrations > *o.lowest) o.output.say(fmt::format("mode {} coincides with the next: {} modes are listed", *o.lowest, vibrations));
  }
  if (c.status == CoverageStatus::complete) return done;
  o.output.say(fmt::format("not certified complete: {}", c.reason));
  return not_certified;
}

}  // namespace

void add_modes(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand("modes", "All modes of a model, or those of a window: frequencies, energy signs, shapes, verdict, certificate");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  auto* lowest = verb->add_option("--lowest", o->lowest, "Only the N lowest that are not rigid-body modes")->type_name("N")->check(CLI::PositiveNumber);
  auto* all = verb->add_flag("--all", o->all, "All modes (the default for dense models)");
  o->window.add_to(*verb);
  for (const char* name : {"--below", "--window"}) {
    lowest->excludes(verb->get_option(name));
    all->excludes(verb->get_option(name));
  }
  all->excludes(lowest);
  verb->add_option("--method", o->method, "auto, quadrature, general, first-order or symmetric-2n (the two classical 2n methods)")
      ->type_name("NAME")
      ->check(CLI::IsMember({"auto", "quadrature", "hidden", "general", "first-order", "symmetric-2n", "exact", "discrete"}))
      ->capture_default_str();
  verb->add_flag("--shapes", o->shapes, "With the mode shapes: motion is Re(X e^{jωt}), largest entry 1");
  o->output.add_to(*verb);
  verb->footer("Examples:\n  gyromode modes models/three_springs.toml --shapes\n  gyromode modes models/wiresaw.toml --lowest 3 --format json\n"
               "  gyromode modes --mass M.mtx --gyroscopic G.mtx --stiffness K.mtx --window 1Hz:50Hz -o modes.csv");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
