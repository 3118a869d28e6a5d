#include "gyromode/write/stability_svg.h"

#include "gyromode/write/chart.h"
#include "gyromode/write/digits.h"
#include "gyromode/write/varied_parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode::io {

namespace {

struct Look {
  std::string letter;
  Chart::Style style;
};

// Lightnesses apart, for grey; letters as those of the chart in text.
Look look_of(const StabilityPoint& p) {
  const auto area = [](std::string letter, std::string name, std::string colour) {
    return Look{std::move(letter), {std::move(name), std::move(colour), "", 1, true}};
  };
  if (!p.law_kept) return area("", "no model", "#f4f4f4");
  switch (p.stability) {
    case Stability::stable: return area("s", "s stable", "#d9efe4");
    case Stability::gyroscopically_stabilised: return area("g", "g gyroscopic", "#8cc3e6");
    case Stability::marginal: return area("m", "m marginal", "#bdbdbd");
    case Stability::unstable: return p.balance.quadruples > 0 ? area("F", "F flutter", "#8c1c3c") : area("D", "D divergence", "#e08a4a");
    default: return area("?", "? unknown", "#ffffff");
  }
}

// The borders of cells half-way between neighbouring values.
std::vector<double> borders(const std::vector<double>& values) {
  const double first = values.size() > 1 ? 0.5 * (values[1] - values[0]) : 0.5,
               last = values.size() > 1 ? 0.5 * (values.back() - values[values.size() - 2]) : 0.5;
  std::vector<double> all{values.front() - first};
  for (std::size_t k = 0; k + 1 < values.size(); ++k) all.push_back(0.5 * (values[k] + values[k + 1]));
  all.push_back(values.back() + last);
  return all;
}

// Verdicts over one parameter reach to the next critical value, and without one half-way to the next point.
std::string over_one(const Model& model, const StabilityReport& r, const VariedParameter& right) {
  const StabilityMap& map = *r.map;
  const std::vector<double>& x = map.axes[0];
  const auto shown = [&](double value) { return right.shown(value); };
  double highest = 0;
  for (const StabilityMap::Cell& c : map.cells) highest = std::max(highest, c.point.growth_rate);
  const double up = highest > 0 ? 1.08 * highest : 1;
  Chart chart("Stability: " + model.title, {right.title(), shown(x.front()), shown(x.size() > 1 ? x.back() : x.front() + 1)},
              {"growth rate [1/s]", 0, up});
  std::vector<std::pair<double, StabilityPoint>> from;  // where a verdict begins to hold
  for (std::size_t k = 0; k < x.size(); ++k) {
    const bool border = k > 0 && std::any_of(map.critical.begin(), map.critical.end(),
                                             [&](const CriticalValue& c) { return c.value > x[k - 1] && c.value < x[k]; });
    if (k == 0 || !border) from.emplace_back(k == 0 ? x[0] : 0.5 * (x[k - 1] + x[k]), map.cells[k].point);
  }
  for (const CriticalValue& c : map.critical) from.emplace_back(c.value, c.to);
  std::stable_sort(from.begin(), from.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t k = 0; k < from.size();) {  // as far as the same verdict goes
    const Look look = look_of(from[k].second);
    std::size_t next = k + 1;
    while (next < from.size() && look_of(from[next].second).style.name == look.style.name) ++next;
    chart.cell(shown(from[k].first), shown(next < from.size() ? from[next].first : x.back()), 0, up, "", look.style);
    k = next;
  }
  std::vector<std::pair<double, double>> growth;
  for (std::size_t k = 0; k < x.size(); ++k) {
    growth.emplace_back(shown(x[k]), map.cells[k].point.growth_rate);
    for (const CriticalValue& c : map.critical) {  // from rest, and to it
      if (k + 1 < x.size() && c.value > x[k] && c.value < x[k + 1] && (c.from.growth_rate == 0 || c.to.growth_rate == 0))
        growth.emplace_back(shown(c.value), 0);
    }
  }
  if (highest > 0) chart.curve(growth, {"growth rate", "#222222", "", 1.8});
  for (const CriticalValue& c : map.critical)
    chart.curve({{shown(c.value), 0}, {shown(c.value), up}}, {"critical value", "#222222", "2 3", 1});
  for (const CriticalValue& c : map.critical)
    chart.label(shown(c.value), 0.95 * up, determined(shown(c.value), shown(0.5 * (c.hi - c.lo)), 6));
  return chart.text();
}

std::vector<double> shown_by(const VariedParameter& p, std::vector<double> values) {
  for (double& v : values) v = p.shown(v);
  return values;
}

std::string over_two(const Model& model, const StabilityReport& r, const VariedParameter& right, const VariedParameter& upwards) {
  const StabilityMap& map = *r.map;
  const std::vector<double> x = borders(shown_by(right, map.axes[0])), y = borders(shown_by(upwards, map.axes[1]));
  Chart chart("Stability: " + model.title, {right.title(), x.front(), x.back()}, {upwards.title(), y.front(), y.back()});
  const std::size_t along = map.axes[0].size();
  for (std::size_t k = 0; k < map.cells.size(); ++k) {
    const Look look = look_of(map.cells[k].point);
    chart.cell(x[k % along], x[k % along + 1], y[k / along], y[k / along + 1], look.letter, look.style);
  }
  return chart.text();
}

}  // namespace

std::string stability_svg(const Model& model, const StabilityReport& report, const Layout& layout) {
  const VariedParameter right(model, report.varied[0], layout.unit);
  return report.varied.size() > 1 ? over_two(model, report, right, {model, report.varied[1], layout.unit}) : over_one(model, report, right);
}

}  // namespace gyromode::io
