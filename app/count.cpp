#include "errors.h"
#include "job.h"
#include "verbs.h"

#include <memory>

namespace gyromode::app {

namespace {

struct Options {
  ModelSource source;
  WindowOption window;
  OutputOption output;
};

ExitCode run(const Options& o) {
  if (!o.window.given()) throw UsageError("count needs a window: --below W or --window A:B");
  Job job(o.source, o.output);
  const Window window = o.window.read();
  const CountResult result = job.answer([&](const Model& m) { return m.count(window); });
  o.output.write(document(job.model(), result, job.timings(), o.output.layout()));
  if (result.status == CountStatus::exact) return ExitCode::done;
  o.output.say(result.status == CountStatus::signed_only
                   ? "only the signed count is known: the index balance of this indefinite K does not close"
                   : "the count is doubtful: an end of the window is on a root to rounding");
  return ExitCode::not_certified;
}

}  // namespace

void add_count(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand("count", "How many modes a window holds, by factorisations at its ends");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  o->window.add_to(*verb);
  o->output.add_to(*verb);
  verb->footer(
      "Examples:\n  gyromode count models/wiresaw.toml --below 20\n  gyromode count models/three_springs.toml --window 10Hz:100Hz");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
