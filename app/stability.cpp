#include "errors.h"
#include "exit_code.h"
#include "job.h"
#include "verbs.h"

#include "gyromode/modes/modes.h"
#include "gyromode/modes/spacecraft.h"

#include <memory>

namespace gyromode::app {

namespace {

struct Options {
  ModelSource source;
  OutputOption output;
};

int run(const Options& o) {
  Job job(o.source, o.output);
  o.source.remark_on_tolerance(o.output);
  ModesOptions options;
  options.structure = o.source.structure();
  if (std::holds_alternative<Spacecraft>(job.model().system)) options.lowest = 1;  // the verdict needs no window
  const ModesResult result = job.solve([&](const auto& system) { return find_modes(system, options); });
  o.output.write(stability_document(job.model(), result, job.timings(), o.output.chosen()));
  if (result.stability != Stability::unknown) return done;
  o.output.say("the verdict is unknown: the index balance does not close");
  return not_certified;
}

}  // namespace

void add_stability(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand("stability", "Stability verdict with its proof: the index balance, negative-energy modes, growth rates");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  o->output.add_to(*verb);
  verb->footer("Examples:\n  gyromode stability models/three_springs.toml\n  gyromode stability models/rigid_body.toml --format json");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
