#include "errors.h"
#include "exit_code.h"
#include "input.h"
#include "output.h"
#include "verbs.h"

#include "gyromode/structure/definiteness.h"

#include <memory>

namespace gyromode::app {

namespace {

struct Options {
  ModelSource source;
  OutputOption output;
  std::string at;
};

Stiffness described(const System& s) {
  const Definiteness d = definiteness(s.stiffness());
  return {d.sign(), d.negative, d.zero};
}
Stiffness described(const FirstOrderSystem&) { return {}; }

int run(const Options& o) {
  Stopwatch watch;
  const io::Model model = o.source.read();
  io::Timings timings;
  timings.read = watch.lap();
  io::StructureReport report;
  report.coupling_tolerance = o.source.coupling_tolerance;
  report.stiffness_applies = std::holds_alternative<System>(model.system);
  std::visit(
      [&](const auto& system) {
        report.structure = analyse(system, o.source.structure());
        report.stiffness = described(system);
        if (!o.at.empty()) {
          const auto solved = without_ignored_couplings(system, o.source.structure());
          report.at = transformation_at(solved, report.structure, frequency_option("--at", o.at));
        }
      },
      model.system);
  timings.solve = watch.lap();
  o.output.write(document(model, report, timings, o.output.chosen()));
  return done;
}

}  // namespace

void add_structure(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand("structure", "What class a model is in and why: which coordinates move in phase, which in quadrature");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  verb->add_option("--at", o->at, "Also the impedance matrix H at this frequency, the transformation and the real symmetric H*")->type_name("W");
  o->output.add_to(*verb);
  verb->footer("Examples:\n  gyromode structure models/wiresaw.toml\n  gyromode structure models/rigid_body.toml --at 0.8 --format json");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
