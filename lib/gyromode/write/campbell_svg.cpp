#include "gyromode/write/campbell_svg.h"

#include "gyromode/write/chart.h"
#include "gyromode/write/varied_parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace gyromode::io {

namespace {

// Colours that those see apart who do not see all (Okabe and Ito), and dashes for grey.
Chart::Style style_of(const std::optional<Whirl>& whirl) {
  if (!whirl) return {"mode", "#555555", ""};
  switch (*whirl) {
    case Whirl::forward: return {"forward", "#0072B2", ""};
    case Whirl::backward: return {"backward", "#D55E00", "7 4"};
    case Whirl::mixed: return {"mixed", "#009E73", "9 3 2 3"};
    default: return {"planar", "#CC79A7", "2 3"};
  }
}

std::string axis_title(const std::string& what, FrequencyUnit unit) { return fmt::format("{} [{}]", what, to_string(unit)); }

// The branch in parts of one whirl each: each part goes on to where the next begins. Degenerate ones go with the next.
void draw(const Campbell& c, const CampbellBranch& b, const Layout& l, Chart& chart) {
  std::vector<std::pair<double, double>> points;
  std::optional<Chart::Style> style;
  const auto finish = [&] {
    if (style && points.size() > 1) chart.curve(points, *style);
  };
  for (std::size_t s = 0; s < c.spins.size(); ++s) {
    if (!b.modes[s]) {
      finish();
      points.clear();
      style.reset();
      continue;
    }
    const SampledMode& m = *b.modes[s];
    points.emplace_back(in_unit(c.spins[s], l.spin_unit), in_unit(m.omega, l.unit));
    if (m.whirl && (*m.whirl == Whirl::degenerate || c.spins[s] == 0)) continue;
    const Chart::Style now = style_of(m.whirl);
    if (style && style->name != now.name) {
      finish();
      points = {points.back()};
    }
    style = now;
  }
  if (!style) style = Chart::Style{"degenerate", "#CC79A7", "2 3"};
  finish();
}

}  // namespace

std::string campbell_svg(const Model& model, const Campbell& c, const Layout& l) {
  double highest = 0;
  for (const CampbellBranch& b : c.branches) {
    for (const auto& m : b.modes) highest = std::max(highest, m ? m->omega : 0.0);
  }
  const double first = in_unit(c.spins.front(), l.spin_unit), last = in_unit(c.spins.back(), l.spin_unit);
  Chart chart("Campbell diagram: " + model.title, {axis_title("speed", l.spin_unit), first, last},
              {axis_title(model.frame == gyromode::Frame::turning ? "frequency in turning axes" : "frequency", l.unit), 0,
               1.05 * in_unit(highest > 0 ? highest : 1, l.unit)});
  for (const Encounter& e : c.encounters) {
    if (e.flutter) chart.band(in_unit((*e.flutter)[0], l.spin_unit), in_unit((*e.flutter)[1], l.spin_unit), {"flutter", "#E00000", "", 8});
  }
  for (const Intersections& line : c.excitation) {
    const auto at = [&](double spin) { return in_unit(line.order * std::abs(spin), l.unit); };
    chart.curve({{first, at(c.spins.front())}, {last, at(c.spins.back())}}, {"excitation", "#888888", "1 3", 1.2});
  }
  for (const CampbellBranch& b : c.branches) draw(c, b, l, chart);
  const auto place = [&](double spin, double omega) { return std::pair(in_unit(spin, l.spin_unit), in_unit(omega, l.unit)); };
  for (const bool marks : {true, false}) {
    const auto put = [&](const std::pair<double, double>& at, const char* shape, const std::string& words) {
      marks ? chart.mark(at.first, at.second, shape) : chart.label(at.first, at.second, words);
    };
    for (const Intersections& line : c.excitation) {
      for (const Intersection& x : line.all) put(place(x.spin, x.omega), "circle", fmt::format("{:.5g}", in_unit(x.spin, l.spin_unit)));
    }
    for (const Encounter& e : c.encounters) {
      if (e.kind == EncounterKind::veering) put(place(e.spin, e.omega), "diamond", fmt::format("gap {:.2g}", in_unit(e.gap, l.unit)));
    }
  }
  for (const Intersections& line : c.excitation) {  // where the line leaves the frame
    const double reach = std::min(c.spins.back(), line.order > 0 ? highest / line.order : c.spins.back());
    chart.label(in_unit(0.97 * reach, l.spin_unit), in_unit(0.97 * line.order * reach, l.unit), fmt::format("{:g}×", line.order));
  }
  return chart.text();
}

std::string critical_map_svg(const Model& model, const CriticalMap& map, const Layout& l) {
  const FrequencyUnit unit = l.spin_unit == FrequencyUnit::radians ? FrequencyUnit::rpm : l.spin_unit;
  double highest = 0;
  for (const CriticalMap::Row& r : map.rows) {
    for (const CriticalSpeed& s : r.speeds.speeds) highest = std::max(highest, s.speed);
  }
  const VariedParameter over(model, map.keys, l.unit);
  Chart chart("Critical speeds: " + model.title,
              {over.title(), over.shown(map.rows.front().value), over.shown(map.rows.back().value), true},
              {axis_title("critical speed", unit), 0, 1.05 * in_unit(highest > 0 ? highest : 1, unit)});
  // The k-th of each whirl is a curve.
  std::map<std::pair<std::string, std::size_t>, std::vector<std::pair<double, double>>> curves;
  std::map<std::string, Chart::Style> styles;
  for (const CriticalMap::Row& r : map.rows) {
    std::map<std::string, std::size_t> count;
    for (const CriticalSpeed& s : r.speeds.speeds) {
      const Chart::Style style = style_of(s.whirl);
      styles[style.name] = style;
      curves[{style.name, count[style.name]++}].emplace_back(over.shown(r.value), in_unit(s.speed, unit));
    }
  }
  for (const auto& [key, points] : curves) chart.curve(points, styles[key.first]);
  return chart.text();
}

}  // namespace gyromode::io
