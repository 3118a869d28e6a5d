#include "gyromode/modes/answer.h"

#include "gyromode/base/error.h"
#include "gyromode/certificate/coverage.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode {

namespace {

Window in_unit_of(const CountedSpectrum& s, const Window& w) { return {w.a / s.unit(), w.b / s.unit()}; }

// Back in rad per unit of time; an end that was not moved is exactly the one asked for.
Window given(const CountedSpectrum& s, const Window& used, const Window& asked) {
  const Window before = in_unit_of(s, asked);
  return {used.a == before.a ? asked.a : used.a * s.unit(), used.b == before.b ? asked.b : used.b * s.unit()};
}

void require_end(const CountedSpectrum& s, const Window& w, const char* what) {
  if (w.open() && !s.finite()) throw InvalidArgument(s.why_an_end() + what + " needed");
}

// Where work was stopped: the roots known by then.
Coverage part_of(const Window& known, const Window& asked, const std::vector<CountedRoot>& listed, double unit) {
  Coverage c;
  c.status = CoverageStatus::incomplete;
  c.window = known;
  c.found = static_cast<Index>(listed.size());
  c.interrupted = true;
  c.reason = known.a > asked.a
                 ? fmt::format("interrupted: modes outside {:.6g} … {:.6g} rad/s were not looked for", known.a * unit, known.b * unit)
                 : fmt::format("interrupted: modes above {:.6g} rad/s were not looked for", known.b * unit);
  return c;
}

// Counted before they are looked for.
void require_listable(const CountedSpectrum& s, const Window& w) {
  if (s.finite() || s.most_roots() == std::numeric_limits<Index>::max()) return;
  const Index inside = s.below(w.b) - s.below(w.a);
  if (inside > s.most_roots())
    throw TooLarge(
        fmt::format("the window holds {} modes: at most {} are listed at a time; ask for narrower ones", inside, s.most_roots()));
}

}  // namespace

void require_options(const ModesOptions& options) {
  require_window(options.window);
  if (options.lowest && *options.lowest < 1) throw InvalidArgument("lowest: at least 1 mode must be asked for");
}

ModesResult modes_of(const CountedSpectrum& s, const ModesOptions& options) {
  require_options(options);
  if (!options.lowest) require_end(s, options.window, "a window with two ends or the number of lowest ones is");
  const Window asked = in_unit_of(s, options.window);
  if (!options.lowest) require_listable(s, asked);
  const std::optional<RootRange> before = options.lowest ? std::nullopt : s.roots_before_counts(asked, options.progress);
  if (s.finite()) options.progress.stage("counts at the ends of the window");
  const FilledWindow lowest = options.lowest ? lowest_window(s, *options.lowest, asked, options.progress) : FilledWindow{};
  const RootRange* const first = options.lowest ? &lowest.found : before ? &*before : nullptr;
  const bool stopped = first && first->known_below < infinity;  // nothing is counted any more
  const WindowEnds ends =
      stopped ? WindowEnds{{asked.a, options.lowest ? infinity : asked.b}, {}, {}} : ends_of(s, options.lowest ? lowest.window : asked);
  const RootRange found = first ? *first : s.roots(ends.window, options.progress);
  const Window known{std::max(ends.window.a, found.known_from), std::min(ends.window.b, found.known_below)};
  const bool part = known.a > ends.window.a || known.b < ends.window.b;
  if (part && !(known.b > known.a)) throw Interrupted();
  std::vector<CountedRoot> listed;
  ModesResult r;
  s.describe(r, options.shapes);
  r.index_balance = s.balance();
  for (const std::size_t i : inside(found.roots, known)) {
    listed.push_back(found.roots[i]);
    r.modes.push_back(found.mode(i, options.shapes));
  }
  const bool interrupted = r.coverage.interrupted;  // as the engine says
  r.coverage = part ? part_of(known, ends.window, listed, s.unit()) : coverage_of(s, ends, listed);
  r.coverage.window = given(s, r.coverage.window, options.window);
  r.coverage.requested = options.window;
  r.coverage.interrupted = r.coverage.interrupted || interrupted;
  std::sort(r.unstable.begin(), r.unstable.end(),
            [](const UnstableMode& a, const UnstableMode& b) { return a.growth_rate > b.growth_rate; });
  return r;
}

CountResult count_of(const CountedSpectrum& s, const Window& requested) {
  require_window(requested);
  require_end(s, requested, "a window with two ends is");
  const WindowEnds ends = ends_of(s, in_unit_of(s, requested));
  CountResult r;
  r.window = given(s, ends.window, requested);
  r.requested = requested;
  r.negative = {ends.low.negative, ends.high.negative};
  r.signed_count = s.direction() * (ends.high.negative - ends.low.negative);
  r.zero = ends.window.a == 0 ? s.zero_roots() : 0;
  if (ends.low.doubtful() || ends.high.doubtful()) {
    r.status = CountStatus::doubtful;
  } else if (const auto* all = s.all_roots()) {  // found without counts: they must agree
    std::vector<CountedRoot> listed;
    for (const std::size_t i : inside(*all, ends.window)) listed.push_back((*all)[i]);
    const Coverage c = coverage_of(s, ends, listed);
    r.count = c.counted;
    r.status = !c.counted ? CountStatus::signed_only : c.status == CoverageStatus::complete ? CountStatus::exact : CountStatus::doubtful;
  } else if (!s.balance().closed) {
    r.status = CountStatus::signed_only;
  } else {
    r.count = counted_in(s, ends);
    r.status = CountStatus::exact;
  }
  return r;
}

}  // namespace gyromode
