#include "gyromode/sweep/stability_map.h"

#include <cmath>

namespace gyromode {

namespace {

// Bisection along one axis. A marginal band as narrow as rounding around a threshold is one critical value.
class Bisection {
 public:
  Bisection(const std::function<StabilityPoint(double)>& verdict, double step) : verdict_(verdict), narrow_(1e-14 * step), band_(1e-8 * step) {}

  void refine(double a, const StabilityPoint& at_a, double b, const StabilityPoint& at_b) {
    if (at_a.alike(at_b)) return;
    const double middle = 0.5 * (a + b);
    if (!(b - a > narrow_) || !(middle > a) || !(middle < b)) {
      found_.push_back({middle, at_a, at_b});
      return;
    }
    const StabilityPoint here = verdict_(middle);
    if (!here.lawful) {  // no model between two verdicts: the change is somewhere in the hole
      found_.push_back({middle, at_a, at_b});
      return;
    }
    refine(a, at_a, middle, here);
    refine(middle, here, b, at_b);
  }

  struct Found {
    double value;
    StabilityPoint from, to;
  };
  // Ascending, marginal bands closed.
  std::vector<Found> values() const {
    std::vector<Found> merged;
    for (const Found& f : found_) {
      if (!merged.empty() && merged.back().to.stability == Stability::marginal && f.value - merged.back().value <= band_) {
        merged.back().value = 0.5 * (merged.back().value + f.value);
        merged.back().to = f.to;
      } else {
        merged.push_back(f);
      }
    }
    std::erase_if(merged, [](const Found& f) { return f.from.alike(f.to); });  // a touch of a margin
    return merged;
  }

 private:
  const std::function<StabilityPoint(double)>& verdict_;
  double narrow_, band_;
  std::vector<Found> found_;
};

}  // namespace

bool StabilityPoint::alike(const StabilityPoint& o) const {
  if (!lawful || !o.lawful) return true;  // where the model ends no verdict changes
  return stability == o.stability && balance.real_pairs == o.balance.real_pairs && balance.quadruples == o.balance.quadruples && balance.negative_energy == o.balance.negative_energy;
}

StabilityPoint stability_point(const ModesResult& r) {
  return {true, r.stability, r.index_balance, r.unstable.empty() ? 0 : r.unstable.front().growth_rate, ""};
}

StabilityMap map_stability(const std::function<StabilityPoint(const std::vector<double>&)>& verdict, std::vector<std::vector<double>> axes,
                           const std::function<void(Index, Index)>& progress) {
  StabilityMap map;
  map.axes = std::move(axes);
  const std::vector<double>& along = map.axes.front();
  const std::vector<double> single{0};
  const bool chart = map.axes.size() > 1;
  const std::vector<double>& across = chart ? map.axes[1] : single;
  const Index all = static_cast<Index>(along.size() * across.size());
  for (const double y : across) {
    const auto point = [&](double x) { return chart ? std::vector<double>{x, y} : std::vector<double>{x}; };
    const std::function<StabilityPoint(double)> on_line = [&](double x) { return verdict(point(x)); };
    const std::size_t first = map.cells.size();
    for (const double x : along) {
      map.cells.push_back({point(x), on_line(x)});
      if (progress) progress(static_cast<Index>(map.cells.size()), all);
    }
    Bisection line(on_line, along.size() > 1 ? along[1] - along[0] : 0);
    for (std::size_t k = 0; k + 1 < along.size(); ++k) line.refine(along[k], map.cells[first + k].point, along[k + 1], map.cells[first + k + 1].point);
    for (const auto& f : line.values()) map.critical.push_back({0, f.value, f.from, f.to, chart ? std::vector<double>{y} : std::vector<double>{}});
  }
  return map;
}

}  // namespace gyromode
