#include "errors.h"
#include "job.h"
#include "verbs.h"

#include "gyromode/modes/spacecraft.h"
#include "gyromode/structure/definiteness.h"

#include <fmt/format.h>

#include <memory>
#include <type_traits>

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
Stiffness described(const Spacecraft& s) {
  ModesOptions options;
  options.lowest = 1;
  return find_modes(s, options).stiffness;
}

// What only a spacecraft has.
void describe_booms(const Spacecraft& s, io::StructureReport& r) {
  constexpr Index lowest_of_a_boom = 5, lowest_modes = 10;
  r.held_booms = held_booms(s, lowest_of_a_boom);
  r.effective_axes = effective_axes(s, lowest_modes);
}
template <class Matrices>
void describe_booms(const Matrices&, io::StructureReport&) {}

Structure searched(const System& s) { return analyse(s, HiddenSearch::always); }
template <class Other>
Structure searched(const Other& s) { return analyse(s); }

template <class Matrices>
ComplexMatrix impedance_of(const Matrices& system, const Options&, double omega) { return system.impedance(omega); }

ComplexMatrix impedance_of(const Spacecraft& spacecraft, const Options& o, double omega) {
  if (!(omega > 0)) throw UsageError(fmt::format("--at {}: a frequency above 0 was expected", o.at));
  return impedance_at(spacecraft, omega);
}

ExitCode run(const Options& o) {
  Job job(o.source, o.output);
  const io::StructureReport report = job.solve([&](const auto& system) {
    io::StructureReport r;
    r.stiffness_applies = !std::is_same_v<std::decay_t<decltype(system)>, FirstOrderSystem>;
    r.structure = searched(system);
    r.stiffness = described(system);
    describe_booms(system, r);
    if (!o.at.empty()) {
      const double omega = frequency_option("--at", o.at);
      r.at = {omega, realify(impedance_of(system, o, omega), r.structure)};
    }
    return r;
  });
  o.output.write(document(job.model(), report, job.timings(), o.output.chosen()));
  return ExitCode::done;
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
