#include "gyromode/stability/stability_map.h"

#include "gyromode/base/error.h"
#include "gyromode/stability/border.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gyromode {

namespace {

struct Place {
  double at;
  const StabilityPoint* point;
};

// Places with a verdict, ascending. One with an open balance is left out beside one with the same verdict: it knows
// less than that.
std::vector<Place> decided(const std::vector<double>& along, const StabilityMap::Cell* cells) {
  std::vector<Place> with_verdict, kept;
  for (std::size_t k = 0; k < along.size(); ++k) {
    if (cells[k].point.decided()) with_verdict.push_back({along[k], &cells[k].point});
  }
  for (std::size_t k = 0; k < with_verdict.size(); ++k) {
    const StabilityPoint& here = *with_verdict[k].point;
    const bool as_before = !kept.empty() && kept.back().point->stability == here.stability;
    const bool as_after = k + 1 < with_verdict.size() && with_verdict[k + 1].point->stability == here.stability;
    if (here.balance.closed || !(as_before || as_after)) kept.push_back(with_verdict[k]);
  }
  return kept;
}

// Bisections of every interval with a border, each down to the resolution: more where a third verdict parts one.
Index expected_evaluations(const std::vector<Place>& places, double range) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    if (places[k].point->differs(*places[k + 1].point))
      sum += std::log2((places[k + 1].at - places[k].at) / (BorderSearch::resolution * range));
  }
  return static_cast<Index>(std::ceil(sum));
}

using Verdict = std::function<StabilityPoint(const std::vector<double>&)>;

// A verdict between the cells that was asked for.
struct Seen {
  double at;
  StabilityPoint point;
};

// One between every two neighbouring thresholds, and between those at the ends and the cells beside them.
std::vector<double> between_thresholds(const std::vector<double>& along, const std::vector<double>& thresholds) {
  std::vector<double> middles;
  for (std::size_t k = 0; k + 1 < along.size(); ++k) {
    std::vector<double> parts{along[k]};
    for (const double t : thresholds) {
      if (t > along[k] && t < along[k + 1]) parts.push_back(t);
    }
    if (parts.size() == 1) continue;
    parts.push_back(along[k + 1]);
    for (std::size_t i = 1; i + 2 < parts.size(); ++i) middles.push_back(0.5 * (parts[i] + parts[i + 1]));
  }
  return middles;
}

// The borders of a row: at a threshold where the verdicts beside it differ, else where a search finds them.
struct RowBorders {
  BorderSearch& search;
  const BorderSearch::Line& at;
  const std::vector<double>& thresholds;  // ascending
  double range;
  std::vector<Border> found = {}, at_thresholds = {};
  Index more_evaluations = 0;

  // Between neighbours with a verdict; there is one threshold between them, or none.
  void add(const Place& lo, const Place& hi) {
    if (!lo.point->differs(*hi.point)) return;
    const auto t = std::upper_bound(thresholds.begin(), thresholds.end(), lo.at);
    if (t == thresholds.end() || !(*t < hi.at)) return search_in(lo.at, *lo.point, hi.at, *hi.point);
    // Beside it, so near that nothing else is between, and far enough for a verdict.
    constexpr double beside = 1e-6;
    const double below = *t - std::min(0.25 * (*t - lo.at), beside * range), above = *t + std::min(0.25 * (hi.at - *t), beside * range);
    const StabilityPoint from = at(below), to = at(above);
    more_evaluations += 2;
    if (!from.decided() || !to.decided()) return search_in(lo.at, *lo.point, hi.at, *hi.point);
    search_in(lo.at, *lo.point, below, from);
    if (from.differs(to)) at_thresholds.push_back({std::nextafter(*t, lo.at), std::nextafter(*t, hi.at), from, to});
    search_in(above, to, hi.at, *hi.point);
  }
  void search_in(double a, const StabilityPoint& at_a, double b, const StabilityPoint& at_b) {
    if (!at_a.differs(at_b)) return;
    for (Border& border : search.between(a, at_a, b, at_b)) found.push_back(std::move(border));
  }
  // Ascending. What is found by a search and narrower than a verdict of its own is one; between thresholds nothing is.
  std::vector<Border> all() {
    std::vector<Border> every = merged(found, BorderSearch::narrowest_verdict * range);
    every.insert(every.end(), std::make_move_iterator(at_thresholds.begin()), std::make_move_iterator(at_thresholds.end()));
    std::sort(every.begin(), every.end(), [](const Border& p, const Border& q) { return p.lo < q.lo; });
    return every;
  }
};

// Roots collide only with those of the other energy sign.
bool may_flutter(const StabilityMap::Cell* cells, std::size_t count) {
  return std::any_of(cells, cells + count, [](const StabilityMap::Cell& c) {
    return c.point.decided() && (c.point.balance.negative_energy > 0 || c.point.balance.quadruples > 0);
  });
}

// One row of the grid, at `rest` of the second parameter (empty without one): its cells, then its borders.
void add_row(const Verdict& verdict, const std::vector<double>& rest, const Progress& progress, const Thresholds& thresholds,
             const Thresholds& suspected, StabilityMap& map) {
  const std::vector<double>& along = map.axes.front();
  const Index all = static_cast<Index>(along.size() * (map.axes.size() > 1 ? map.axes[1].size() : 1));
  const auto point = [&](double x) {
    std::vector<double> values{x};
    values.insert(values.end(), rest.begin(), rest.end());
    return values;
  };
  const BorderSearch::Line at = [&](double x) {
    if (progress.stopped()) throw Interrupted();
    return verdict(point(x));
  };
  const std::size_t first = map.cells.size();
  for (const double x : along) {
    map.cells.push_back({point(x), at(x)});
    progress.report("cells", static_cast<Index>(map.cells.size()), all);
  }
  const double range = along.back() - along.front();
  std::vector<double> known = thresholds ? thresholds(rest) : std::vector<double>{};
  std::sort(known.begin(), known.end());
  std::vector<Seen> seen;
  std::vector<double> parted = known;
  if (suspected && (!known.empty() || may_flutter(map.cells.data() + first, along.size()))) {
    const std::vector<double> ends = suspected(rest);
    parted.insert(parted.end(), ends.begin(), ends.end());
    std::sort(parted.begin(), parted.end());
  }
  for (const double x : between_thresholds(along, parted)) {
    seen.push_back({x, at(x)});
    ++map.evaluations;
  }
  std::vector<Place> places = decided(along, map.cells.data() + first);
  for (const Seen& s : seen) {
    if (s.point.decided()) places.push_back({s.at, &s.point});
  }
  std::sort(places.begin(), places.end(), [](const Place& p, const Place& q) { return p.at < q.at; });
  const Index expected = expected_evaluations(places, range);
  Index evaluated = 0;
  BorderSearch search(
      [&](double x) {
        progress.report("verdicts between cells", evaluated++, expected);
        return at(x);
      },
      range);
  RowBorders borders{search, at, known, range};
  bool stopped = false;
  try {
    for (std::size_t k = 0; k + 1 < places.size(); ++k) borders.add(places[k], places[k + 1]);
  } catch (const Interrupted&) {  // borders found by then are kept
    stopped = true;
  }
  for (Border& b : borders.all()) map.critical.push_back({0, b.middle(), b.lo, b.hi, std::move(b.from), std::move(b.to), rest});
  map.evaluations += search.evaluations() + borders.more_evaluations;
  if (stopped) throw Interrupted();
}

// Cells that were not looked at: no verdict.
void fill(StabilityMap& map) {
  StabilityPoint none;
  none.reason = "interrupted";
  const std::vector<double>& along = map.axes.front();
  const std::size_t rows = map.axes.size() > 1 ? map.axes[1].size() : 1;
  for (std::size_t k = map.cells.size(); k < along.size() * rows; ++k) {
    std::vector<double> at{along[k % along.size()]};
    if (map.axes.size() > 1) at.push_back(map.axes[1][k / along.size()]);
    map.cells.push_back({std::move(at), none});
  }
}

}  // namespace

StabilityMap map_stability(const Verdict& verdict, std::vector<std::vector<double>> axes, const Progress& progress,
                           const Thresholds& thresholds, const Thresholds& suspected) {
  if (axes.empty() || axes.size() > 2) throw InvalidArgument(fmt::format("a map has one parameter or two: {} were given", axes.size()));
  for (const std::vector<double>& values : axes) {
    if (values.empty() || !std::is_sorted(values.begin(), values.end()))
      throw InvalidArgument("the values of a parameter must ascend, and there must be some");
  }
  StabilityMap map;
  map.axes = std::move(axes);
  try {
    if (map.axes.size() == 1)
      add_row(verdict, {}, progress, thresholds, suspected, map);
    else
      for (const double y : map.axes[1]) add_row(verdict, {y}, progress, thresholds, suspected, map);
  } catch (const Interrupted&) {
    map.interrupted = true;
    fill(map);
  }
  return map;
}

}  // namespace gyromode
