#include "gyromode/write/digits.h"
#include "gyromode/write/varied_parameter.h"
#include "gyromode/write/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace gyromode::io {

namespace {

constexpr double rpm = 30 / std::numbers::pi;

Json whirl_json(const CriticalSpeed& s) { return s.whirl ? Json(to_string(*s.whirl)) : Json(nullptr); }

// Speeds of a map: rpm, unless another unit was asked for.
FrequencyUnit map_unit(const Writer& w) { return w.spins_in_radians() ? FrequencyUnit::rpm : w.layout().spin_unit; }
double shown(double speed, const Writer& w) { return in_unit(speed, map_unit(w)); }
std::string_view shown_unit(const Writer& w) { return to_string(map_unit(w)); }

}  // namespace

void describe(const Model& model, const CriticalSpeeds& r, Writer& w) {
  w.fact("order", r.order, "order",
         r.in_fixed_axes && r.order == 0 ? "at rest in fixed axes: at 1 × speed in the turning axes of the model"
         : r.in_fixed_axes ? fmt::format("{0:g} × speed in fixed axes: forward whirl at {1:g} × speed in the turning axes of the model, "
                                         "backward at {2:g} ×",
                                         r.order, std::abs(r.order - 1), r.order + 1)
                           : fmt::format("{:g} × speed", r.order));
  if (r.other_way > 0)
    w.fact("other_way", r.other_way, "left out",
           fmt::format("{} roots whose places go round the other way, and have another order in fixed axes", r.other_way));
  describe_coverage(r.coverage, w.layout().spin_unit, w);
  w.fact("not_physical", r.not_physical, "not real",
         r.not_physical == 0 ? "" : fmt::format("{} roots with Ω² ≤ 0 or not real", r.not_physical));
  w.table({"critical_speeds",
           "",
           {{"", "#"},
            {w.spin_key("omega"), w.spin_heading()},
            {"rpm", w.spins_in_radians() ? "speed [rpm]" : ""},
            {"whirl", r.in_fixed_axes ? "whirl in fixed axes" : "whirl"},
            {"multiple", r.in_fixed_axes ? "× speed in turning axes" : "", "{:g}"},
            {"residual", "residual", "{:.1e}"},
            {w.spin_key("error_bound")},
            {"shape", "", "", Column::In::json}},
           static_cast<Index>(r.speeds.size()),
           [&](Index k) {
             const CriticalSpeed& s = r.speeds[static_cast<std::size_t>(k)];
             return std::vector<Cell>{{k + 1},
                                      {w.spin(s.speed), determined(w.spin(s.speed), w.spin(s.error_bound))},
                                      {s.speed * rpm, determined(s.speed * rpm, s.error_bound * rpm, 10)},
                                      {whirl_json(s), s.whirl ? std::string(to_string(*s.whirl)) : "–"},
                                      {s.multiple},
                                      {s.residual},
                                      {w.spin(s.error_bound)},
                                      {shape_json(model.labels(), s.shape)}};
           },
           true});
}

// People see a row a value with as many speeds as a line holds; programs every speed of every value.
void describe(const Model& model, const CriticalMap& map, Writer& w) {
  constexpr std::size_t most_columns = 6;
  std::size_t most = 0;
  for (const CriticalMap::Row& r : map.rows) most = std::max(most, r.speeds.speeds.size());
  const VariedParameter over(model, map.keys, w.layout().unit);
  if (!map.rows.empty())
    w.fact("order", map.rows.front().speeds.order, "order",
           fmt::format("{:g} × speed; critical speeds in {}", map.rows.front().speeds.order, shown_unit(w)));
  w.fact("over", map.keys);
  if (map.interrupted) w.fact("interrupted", true, "interrupted", "higher values were not looked at");
  Table seen{"", "", {{"", over.title()}}, static_cast<Index>(map.rows.size()), {}};
  for (std::size_t c = 0; c < std::min(most, most_columns); ++c) seen.columns.push_back({"", fmt::format("{}", c + 1)});
  seen.columns.push_back({"", "counted"});
  seen.row = [&](Index k) {
    const CriticalMap::Row& r = map.rows[static_cast<std::size_t>(k)];
    std::vector<Cell> cells{{nullptr, fmt::format("{:.6g}", over.shown(r.value))}};
    for (std::size_t c = 0; c < std::min(most, most_columns); ++c) {
      const bool there = c < r.speeds.speeds.size();
      cells.push_back({nullptr, there ? determined(shown(r.speeds.speeds[c].speed, w), shown(r.speeds.speeds[c].error_bound, w), 7) : ""});
    }
    cells.push_back({nullptr, r.reason.empty() ? std::string(to_string(r.speeds.coverage.status)) : "no model"});
    return cells;
  };
  w.table(seen);
  if (w.for_csv()) {  // a line a speed
    std::vector<std::pair<const CriticalMap::Row*, const CriticalSpeed*>> all;
    for (const CriticalMap::Row& r : map.rows) {
      for (const CriticalSpeed& s : r.speeds.speeds) all.emplace_back(&r, &s);
    }
    w.table({"",
             "",
             {{map.keys}, {w.spin_key("omega")}, {"rpm"}, {"whirl"}, {w.spin_key("error_bound")}},
             static_cast<Index>(all.size()),
             [all, &w](Index k) {
               const auto& [r, s] = all[static_cast<std::size_t>(k)];
               return std::vector<Cell>{{r->value}, {w.spin(s->speed)}, {s->speed * rpm}, {whirl_json(*s)}, {w.spin(s->error_bound)}};
             },
             true});
    return;
  }
  w.table({"map", "", {{"value"}, {"status"}, {"critical_speeds"}, {"reason"}}, static_cast<Index>(map.rows.size()), [&](Index k) {
             const CriticalMap::Row& r = map.rows[static_cast<std::size_t>(k)];
             Json speeds = Json::array();
             for (const CriticalSpeed& s : r.speeds.speeds)
               speeds.push_back({{"omega", s.speed}, {"rpm", s.speed * rpm}, {"whirl", whirl_json(s)}, {"error_bound", s.error_bound}});
             return std::vector<Cell>{{r.value},
                                      {r.reason.empty() ? Json(to_string(r.speeds.coverage.status)) : Json(nullptr)},
                                      {speeds},
                                      {r.reason.empty() ? no_value : Json(r.reason)}};
           }});
}

}  // namespace gyromode::io
