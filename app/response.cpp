#include "errors.h"
#include "job.h"
#include "grids.h"
#include "load.h"
#include "response_options.h"
#include "verbs.h"

#include "gyromode/base/error.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/read/initial_state.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace gyromode::app {

namespace {

Vector times_of(const ResponseOptions& o) {
  if (!o.times.empty()) {
    if (o.until || o.step) throw UsageError("--times gives the times by itself: leave out --until and --step");
    return io::read_times(o.times);
  }
  if (!o.until || !o.step) throw UsageError("response needs times: --until T --step DT, or --times FILE");
  return time_grid(time_option("--until", *o.until), time_option("--step", *o.step));
}

ResponseReport moved(const Model& m, const ResponseOptions& o, const Progress& progress) {
  m.body->require_motion();
  const State start = o.initial.empty() ? State::rest(m.size()) : io::read_initial_state(o.initial, m.labels());
  MotionRequest request{start, forces_of(o.forces, m.labels()), points_of(o.points), times_of(o), o.rates, progress};
  std::vector<const Vector*> driving{&request.initial.q, &request.initial.qdot};
  for (const Force& f : request.forces) driving.push_back(&f.amplitude);
  request.chosen = chosen_of(o, m, driving);
  choose_modes(o, m, request);
  return m.response(request);
}

FrequencyReport swept(const Model& m, const ResponseOptions& o, const Progress& progress) {
  FrequencyRequest request{amplitude_of(o.forces, m.labels()), frequency_grid("--frequencies", o.frequencies), progress};
  request.chosen = chosen_of(o, m, {&request.amplitude});
  return m.frequency_response(request);
}

// Those of --spin, else that of the model.
Vector speeds_of(const ResponseOptions& o, const Model& m) {
  if (!o.spin.empty()) return frequency_grid("--spin", o.spin);
  if (!m.spin) throw UsageError("--unbalance needs speeds: --spin A:B:N, such as 0:6000rpm:200");
  return Vector::Constant(1, std::abs(*m.spin));
}

ExitCode run_unbalance(const ResponseOptions& o) {
  if (!o.initial.empty() || o.until || o.step || !o.times.empty() || !o.points.empty() || !o.forces.empty() || !o.frequencies.empty())
    throw UsageError("--unbalance is the steady response over speeds: it goes with --spin A:B:N, and no forces, frequencies or times");
  UnbalanceRequest request;
  request.masses = unbalances_of(o.unbalances);
  Job job(o.source, o.output);
  const UnbalanceReport report = job.answer([&](const Model& m, const Progress& progress) {
    request.speeds = speeds_of(o, m);
    request.progress = progress;
    return m.unbalance_response(request);
  });
  o.output.write(document(job.model(), report, job.timings(), o.output.layout(o.spin.empty() ? Format::table : Format::csv)));
  for (const std::string& remark : report.remarks()) o.output.say(remark);
  return report.response.interrupted ? job.interrupted() : ExitCode::done;
}

ExitCode run(const ResponseOptions& given) {
  ResponseOptions o = given;
  o.output.pictures = true;
  if (!o.unbalances.empty()) return run_unbalance(o);
  if (!o.spin.empty()) throw UsageError("--spin goes with --unbalance PLACE=UNBALANCE");
  const bool sweep = !o.frequencies.empty();
  if (sweep && (!o.initial.empty() || o.until || o.step || !o.times.empty() || !o.points.empty()))
    throw UsageError("--frequencies is the response at steady frequencies: no initial state, no times");
  if (sweep && (o.window.given() || o.lowest))
    throw UsageError(
        "--frequencies solves for the response point by point, not mode by mode: it goes without --lowest, --below and --window");
  if (sweep && o.forces.empty()) throw UsageError("--frequencies needs a force: --force LABEL=F");
  if (!sweep && o.initial.empty() && o.forces.empty())
    throw UsageError("nothing moves: give --initial FILE.csv (columns label,q,qdot), --force, or --unbalance");
  Job job(o.source, o.output);
  if (sweep) {
    const FrequencyReport report = job.answer([&](const Model& m, const Progress& p) { return swept(m, o, p); });
    o.output.write(document(job.model(), report, job.timings(), o.output.layout(Format::csv)));
    for (const std::string& remark : report.remarks()) o.output.say(remark);
    if (report.response.interrupted) return job.interrupted();
    const auto& coverage = report.response.coverage;
    return !coverage || coverage->status == CoverageStatus::complete ? ExitCode::done : ExitCode::not_certified;
  }
  const ResponseReport report = job.answer([&](const Model& m, const Progress& p) { return moved(m, o, p); });
  o.output.write(document(job.model(), report, job.timings(), o.output.layout(Format::csv)));
  if (!report.remark.empty()) o.output.say(report.remark);
  if (report.history.interrupted) return job.interrupted();
  for (const std::string& doubt : report.doubts()) o.output.say("not certified: " + doubt);
  return report.doubts().empty() ? ExitCode::done : ExitCode::not_certified;
}

}  // namespace

void add_response(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand(
      "response", "Motion over time from initial conditions and forces, mode by mode; or the steady response to forces, or to unbalance");
  auto o = std::make_shared<ResponseOptions>();
  o->source.add_to(*verb);
  verb->add_option("--initial", o->initial, "Initial displacements and velocities: CSV with the columns label,q,qdot")
      ->type_name("FILE.csv");
  verb->add_option("--until", o->until, "Last time: s, or 20ms, 2min")->type_name("T");
  verb->add_option("--step", o->step, "Time between rows, likewise (output only: there is no time stepping)")->type_name("DT");
  verb->add_option("--times", o->times, "Times instead of --until and --step: one a line, increasing")->type_name("FILE");
  verb->add_option("--force", o->forces,
                   "impulse:LABEL=P,…  step:LABEL=F,…  harmonic:LABEL=F,…@W (F cos Wt); with --frequencies LABEL=F,…; a label with , or = "
                   "in double quotes, or #N for its position")
      ->type_name("FORCE")
      ->take_all();
  verb->add_option(
          "--unbalance", o->unbalances,
          "Rotors: masses out of balance, kg m or with a unit (g mm), at disk1, station4, …, with @phase: the response Ω²·m·e over "
          "the speeds of --spin, points added beside critical speeds")
      ->type_name("PLACE=U[@PHASE],…")
      ->take_all();
  verb->add_option("--spin", o->spin, "With --unbalance: N speeds from A to B; without, the speed of the model")->type_name("A:B:N");
  verb->add_option("--frequencies", o->frequencies,
                   "The response q of q e^{jωt} at N frequencies from A to B instead, points added beside resonances")
      ->type_name("A:B:N");
  verb->add_option("--points", o->points,
                   "Spacecraft: also the displacement of these places: cable1@0.5 (from root 0 to tip 1), beam1@1, mass1")
      ->type_name("PLACE")
      ->delimiter(',');
  verb->add_option("--only", o->only, "These coordinates alone, LABEL,LABEL,… (default all; of a large sparse model those that are driven)")
      ->type_name("LABELS");
  auto* lowest =
      verb->add_option("--lowest", o->lowest, "Large sparse models: the motion in the N lowest modes (default 10), with what is left out")
          ->type_name("N")
          ->check(whole_above_zero());
  o->window.add_to(*verb);
  for (const char* name : {"--below", "--window"}) lowest->excludes(verb->get_option(name));
  verb->add_flag("--rates", o->rates, "Also velocities, one column more a coordinate");
  o->output.add_to(*verb);
  verb->footer(
      "Without --format the result is CSV.\nExamples:\n  gyromode response models/rigid_body.toml --initial tilt.csv --until 60 --step 0.5 "
      "-o tilt.json\n"
      "  gyromode response models/three_springs.toml --force impulse:y=1 --until 0.1 --step 0.001\n"
      "  gyromode response models/three_springs.toml --force x=1 --frequencies 10Hz:200Hz:100 -o response.csv\n"
      "  gyromode response models/rotors/two_discs.toml --unbalance disk2=1e-4 --spin 0:6000rpm:200 -o unbalance.csv\n"
      "  gyromode response models/geos.toml --force impulse:theta1=10 --points cable1@1 --until 120 --step 1");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
