#include "errors.h"
#include "exit_code.h"
#include "input.h"
#include "output.h"
#include "verbs.h"

#include "gyromode/modes/modes.h"

#include <fmt/format.h>

#include <memory>

namespace gyromode::app {

namespace {

struct Options {
  ModelSource source;
  OutputOption output;
};

int run(const Options& o) {
  Stopwatch watch;
  const io::Model model = o.source.read();
  if (o.source.coupling_tolerance > 0) o.output.say(fmt::format("couplings up to {:.2g} of the largest entry are left out, as asked", o.source.coupling_tolerance));
  io::Timings timings;
  timings.read = watch.lap();
  ModesOptions options;
  options.structure = o.source.structure();
  const ModesResult result = std::visit([&](const auto& system) { return find_modes(system, options); }, model.system);
  timings.solve = watch.lap();
  o.output.write(stability_document(model, result, timings, o.output.chosen()));
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
