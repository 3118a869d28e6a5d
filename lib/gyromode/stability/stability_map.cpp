#include "gyromode/stability/stability_map.h"

#include "gyromode/stability/border.h"

namespace gyromode {

namespace {

struct Place {
  double at;
  const StabilityPoint* point;
};

// Places with a verdict, ascending. One with an open balance is left out beside one with the same verdict: it knows less than that.
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

}  // namespace

StabilityMap map_stability(const std::function<StabilityPoint(const std::vector<double>&)>& verdict, std::vector<std::vector<double>> axes,
                           const std::function<void(Index, Index)>& progress) {
  StabilityMap map;
  map.axes = std::move(axes);
  const std::vector<double>& along = map.axes.front();
  const std::vector<double> single{0};
  const bool chart = map.axes.size() > 1;
  const std::vector<double>& across = chart ? map.axes[1] : single;
  const Index all = static_cast<Index>(along.size() * across.size());
  const double range = along.back() - along.front();
  for (const double y : across) {
    const auto point = [&](double x) { return chart ? std::vector<double>{x, y} : std::vector<double>{x}; };
    const std::size_t first = map.cells.size();
    for (const double x : along) {
      map.cells.push_back({point(x), verdict(point(x))});
      if (progress) progress(static_cast<Index>(map.cells.size()), all);
    }
    BorderSearch search([&](double x) { return verdict(point(x)); }, range);
    std::vector<Border> borders;
    const std::vector<Place> places = decided(along, map.cells.data() + first);
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      if (!places[k].point->differs(*places[k + 1].point)) continue;
      for (Border& b : search.between(places[k].at, *places[k].point, places[k + 1].at, *places[k + 1].point)) borders.push_back(std::move(b));
    }
    for (Border& b : merged(borders, BorderSearch::narrowest_verdict * range)) {
      map.critical.push_back({0, b.middle(), b.lo, b.hi, std::move(b.from), std::move(b.to), chart ? std::vector<double>{y} : std::vector<double>{}});
    }
    map.evaluations += search.evaluations();
  }
  return map;
}

}  // namespace gyromode
