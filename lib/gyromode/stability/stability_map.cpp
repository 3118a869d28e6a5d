#include "gyromode/stability/stability_map.h"

#include "gyromode/base/error.h"
#include "gyromode/stability/border.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

// One row of the grid, at `rest` of the second parameter (empty without one): its cells, then its borders.
void add_row(const Verdict& verdict, const std::vector<double>& rest, const Progress& progress, StabilityMap& map) {
  const std::vector<double>& along = map.axes.front();
  const Index all = static_cast<Index>(along.size() * (map.axes.size() > 1 ? map.axes[1].size() : 1));
  const auto point = [&](double x) {
    std::vector<double> values{x};
    values.insert(values.end(), rest.begin(), rest.end());
    return values;
  };
  const auto at = [&](double x) {
    if (progress.stopped()) throw Interrupted();
    return verdict(point(x));
  };
  const std::size_t first = map.cells.size();
  for (const double x : along) {
    map.cells.push_back({point(x), at(x)});
    progress.report("cells", static_cast<Index>(map.cells.size()), all);
  }
  const double range = along.back() - along.front();
  const std::vector<Place> places = decided(along, map.cells.data() + first);
  const Index expected = expected_evaluations(places, range);
  Index evaluated = 0;
  BorderSearch search(
      [&](double x) {
        progress.report("verdicts between cells", evaluated++, expected);
        return at(x);
      },
      range);
  std::vector<Border> borders;
  bool stopped = false;
  try {
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      if (!places[k].point->differs(*places[k + 1].point)) continue;
      for (Border& b : search.between(places[k].at, *places[k].point, places[k + 1].at, *places[k + 1].point))
        borders.push_back(std::move(b));
    }
  } catch (const Interrupted&) {  // borders found by then are kept
    stopped = true;
  }
  for (Border& b : merged(borders, BorderSearch::narrowest_verdict * range))
    map.critical.push_back({0, b.middle(), b.lo, b.hi, std::move(b.from), std::move(b.to), rest});
  map.evaluations += search.evaluations();
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

StabilityMap map_stability(const Verdict& verdict, std::vector<std::vector<double>> axes, const Progress& progress) {
  if (axes.empty() || axes.size() > 2) throw InvalidArgument(fmt::format("a map has one parameter or two: {} were given", axes.size()));
  for (const std::vector<double>& values : axes) {
    if (values.empty() || !std::is_sorted(values.begin(), values.end()))
      throw InvalidArgument("the values of a parameter must ascend, and there must be some");
  }
  StabilityMap map;
  map.axes = std::move(axes);
  try {
    if (map.axes.size() == 1)
      add_row(verdict, {}, progress, map);
    else
      for (const double y : map.axes[1]) add_row(verdict, {y}, progress, map);
  } catch (const Interrupted&) {
    map.interrupted = true;
    fill(map);
  }
  return map;
}

}  // namespace gyromode
