#include "errors.h"
#include "job.h"
#include "verbs.h"

#include "gyromode/base/error.h"
#include "gyromode/base/number.h"
#include "gyromode/read/varied_model.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace gyromode::app {

namespace {

struct Options {
  ModelSource source;
  OutputOption output;
  std::vector<std::string> vary;
};

// KEY=A:B:N
struct Axis {
  std::string key;
  std::vector<double> values;
};

double bound(const std::string& key, const std::string& text, const std::string& whole) {
  const auto value = io::parse_value_of(key, text);
  if (!value) throw UsageError(fmt::format("--vary {}: '{}' is no number in SI or with a unit that fits '{}'", whole, text, key));
  return *value;
}

Axis axis_of(const std::string& text) {
  constexpr std::int64_t most = 100000;
  const std::size_t equals = text.rfind('='), first = text.find(':', equals), second = first == std::string::npos ? first : text.find(':', first + 1);
  if (equals == std::string::npos || second == std::string::npos) throw UsageError(fmt::format("--vary {}: KEY=A:B:N was expected, such as spin=5rpm:20rpm:31", text));
  Axis axis{text.substr(0, equals), {}};
  const double a = bound(axis.key, text.substr(equals + 1, first - equals - 1), text), b = bound(axis.key, text.substr(first + 1, second - first - 1), text);
  const auto n = whole_number(text.substr(second + 1));
  if (!n || *n < 2 || *n > most) throw UsageError(fmt::format("--vary {}: a number of values from 2 to {} was expected at the end", text, most));
  if (!(b > a) || !std::isfinite(b - a)) throw UsageError(fmt::format("--vary {}: finite A < B was expected", text));
  for (std::int64_t k = 0; k < *n; ++k) axis.values.push_back(k + 1 == *n ? b : a + (b - a) * static_cast<double>(k) / static_cast<double>(*n - 1));
  return axis;
}

StabilityPoint verdict_at(const io::VariedModel& varied, const std::vector<std::string>& keys, const std::vector<double>& values, const Options& o) {
  try {
    return stability_point(o.source.admitted(varied.at(keys, values)).body->verdict(false));
  } catch (const LawBroken& e) {
    StabilityPoint p;
    p.law_kept = false;
    p.reason = e.what();
    return p;
  }
}

// What a map may take: a million verdicts of some milliseconds are an hour or more.
void require_bounded(const std::vector<Axis>& axes) {
  constexpr std::size_t most_cells = 1000000;
  std::size_t cells = 1;
  for (const Axis& axis : axes) cells *= axis.values.size();
  if (cells > most_cells) {
    throw UsageError(fmt::format("--vary: {} × {} = {} cells are more than the {} that a map may have: ask for fewer values", axes[0].values.size(), axes[1].values.size(), cells, most_cells));
  }
}

StabilityMap mapped(const Options& o, const std::vector<Axis>& axes, std::vector<std::string>& keys) {
  const io::VariedModel varied{std::filesystem::path(o.source.model)};
  std::vector<std::vector<double>> values;
  for (const Axis& axis : axes) {
    try {
      varied.require_key(axis.key);
    } catch (const InvalidArgument& e) {
      throw UsageError(fmt::format("--vary: {}", e.what()));
    }
    keys.push_back(axis.key);
    values.push_back(axis.values);
  }
  Stopwatch since;
  double quiet = 0;
  const auto progress = [&](Index done_cells, Index all) {
    constexpr double seconds_between_words = 5;
    quiet += since.lap();
    if (quiet < seconds_between_words) return;
    quiet = 0;
    o.output.say(fmt::format("{} of {} cells", done_cells, all));
  };
  return map_stability([&](const std::vector<double>& at) { return verdict_at(varied, keys, at, o); }, std::move(values), progress);
}

ExitCode run(const Options& o) {
  std::vector<Axis> axes;
  for (const std::string& text : o.vary) axes.push_back(axis_of(text));
  if (axes.size() == 2 && axes[0].key == axes[1].key) throw UsageError(fmt::format("--vary: '{}' is given twice", axes[0].key));
  if (axes.size() > 2) throw UsageError("--vary: one parameter, or two for a chart");
  require_bounded(axes);
  if (!axes.empty() && o.source.model.empty()) throw UsageError("--vary changes numbers of a model file: give one instead of --mass and --stiffness");
  Job job(o.source, o.output);
  StabilityReport report = job.answer([](const ModelKind& m) { return m.stability(); });
  if (!axes.empty()) report.map = mapped(o, axes, report.varied);
  o.output.write(document(job.model(), report, job.timings(), o.output.chosen()));
  if (report.result.stability != Stability::unknown) return ExitCode::done;
  o.output.say(fmt::format("the verdict is unknown: {}", report.result.coverage.reason));
  return ExitCode::not_certified;
}

}  // namespace

void add_stability(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand("stability", "Stability verdict with its proof: the index balance, negative-energy modes, growth rates, margins; mapped over parameters");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  verb->add_option("--vary", o->vary,
                   "Also the verdict at N values from A to B of a number of the model file, and the critical values between; twice: a chart. KEY is its dotted path, arrays from 0, [*] for all items; "
                   "SI, or each bound with its own unit")
      ->type_name("KEY=A:B:N")
      ->take_all();
  o->output.add_to(*verb);
  verb->footer("Examples:\n  gyromode stability models/three_springs.toml\n  gyromode stability models/rigid_body.toml --format json\n"
               "  gyromode stability models/three_springs.toml --vary spin=0:12000rpm:25\n"
               "  gyromode stability models/geos.toml --vary 'cable[*].length=5:40:8'\n"
               "  gyromode stability models/mms.toml --vary body.inertia[2]=500:3000:6 --format json");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
