#include "errors.h"
#include "job.h"
#include "verbs.h"

#include <memory>
#include <optional>

namespace gyromode::app {

namespace {

struct Options {
  ModelSource source;
  OutputOption output;
  std::string at;
};

ExitCode run(const Options& o) {
  Job job(o.source, o.output);
  const auto at = o.at.empty() ? std::nullopt : std::optional(frequency_option("--at", o.at));
  const StructureReport report = job.answer([&](const Model& m) { return m.structure(at); });
  o.output.write(document(job.model(), report, job.timings(), o.output.layout()));
  return ExitCode::done;
}

}  // namespace

void add_structure(CLI::App& program, int& code) {
  CLI::App* verb =
      program.add_subcommand("structure", "What class a model is in and why: which coordinates move in phase, which in quadrature");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  verb->add_option("--at", o->at, "Also the impedance matrix H at this frequency, the transformation and the real symmetric H*")
      ->type_name("W");
  o->output.add_to(*verb);
  verb->footer("Examples:\n  gyromode structure models/wiresaw.toml\n  gyromode structure models/rigid_body.toml --at 0.8 --format json");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
