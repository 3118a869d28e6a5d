#include "errors.h"
#include "grids.h"
#include "job.h"
#include "verbs.h"

#include "gyromode/base/number.h"

#include <fmt/format.h>

#include <memory>
#include <sstream>

namespace gyromode::app {

namespace {

struct Options {
  ModelSource source;
  OutputOption output;
  std::string spin;
  std::optional<std::string> below;
  std::optional<Index> lowest;
  std::string orders = "1";
};

std::vector<double> orders_of(const std::string& text) {
  std::vector<double> all;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const Parsed order = parse_real(part);
    if (order.outcome != Parsed::ok || !(order.value >= 0))
      throw UsageError(fmt::format("--order {}: multiples of the speed were expected, such as 1 or 0.5,1,2", text));
    all.push_back(order.value);
  }
  return all;
}

ExitCode run(const Options& given) {
  Options o = given;
  constexpr Index usual = 10;
  CampbellOptions options;
  const Vector spins = frequency_grid("--spin", o.spin);
  options.spins.assign(spins.begin(), spins.end());
  if (o.below) options.below = frequency_option("--below", *o.below);
  options.lowest = o.lowest;
  if (!o.below && !o.lowest) options.lowest = usual;
  options.orders = orders_of(o.orders);
  o.output.pictures = true;
  Job job(o.source, o.output);
  const Campbell result = job.answer([&](const Model& m, const Progress& progress) {
    options.progress = progress;
    return m.campbell(options);
  });
  o.output.write(document(job.model(), result, job.timings(), o.output.layout()));
  if (result.interrupted) return job.interrupted();
  if (result.is_complete()) return ExitCode::done;
  o.output.say("not certified complete at every spin");
  return ExitCode::not_certified;
}

}  // namespace

void add_campbell(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand(
      "campbell", "Campbell diagram: frequencies over the spin, followed as branches, with whirl, crossings, veerings and excitations");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  verb->add_option("--spin", o->spin, "N spins from A to B; each bound a number in rad/s or with its own unit")
      ->type_name("A:B:N")
      ->required();
  auto* below = verb->add_option("--below", o->below, "Modes below this frequency at every spin")->type_name("W");
  verb->add_option("--lowest", o->lowest, "The N lowest modes at every spin; 10 unless told otherwise")
      ->type_name("N")
      ->check(whole_above_zero())
      ->excludes(below);
  verb->add_option("--order", o->orders, "Multiples of the spin whose lines are intersected with the branches")
      ->type_name("M,…")
      ->capture_default_str();
  o->output.add_to(*verb);
  verb->footer(
      "Examples:\n  gyromode campbell models/rotors/overhung_disc.toml --spin 0:20000rpm:41 --lowest 6\n"
      "  gyromode campbell models/rotors/two_discs.toml --spin 0:12000rpm:25 --order 0.5,1,2 -o two_discs.csv\n"
      "  gyromode campbell models/geos.toml --spin 5rpm:15rpm:5 --below 4 --format json");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
