#include "gyromode/write/digits.h"
#include "gyromode/write/words.h"

#include <fmt/format.h>

#include <numbers>

namespace gyromode::io {

void describe(const Model& model, const CriticalSpeeds& r, Writer& w) {
  const Coverage& c = r.coverage;
  w.fact("order", r.order, "order",
         fmt::format("{:g} × speed{}", r.order, model.frame == gyromode::Frame::turning ? ", in the turning axes of the model" : ""));
  w.fact("coverage",
         {{"status", to_string(c.status)},
          {"window", bounds(c.window)},
          {"requested", bounds(c.requested)},
          {"found", c.found},
          {"counted", c.counted ? Json(*c.counted) : Json(nullptr)}},
         "coverage", coverage_words(c));
  if (!c.reason.empty()) w.fact("coverage.reason", c.reason);
  w.fact("not_physical", r.not_physical, "not real",
         r.not_physical == 0 ? "" : fmt::format("{} roots with Ω² ≤ 0 or not real", r.not_physical));
  constexpr double rpm = 30 / std::numbers::pi;
  w.table({"critical_speeds",
           "",
           {{"", "#"},
            {"omega", "Ω [rad/s]"},
            {"rpm", "speed [rpm]"},
            {"whirl", "whirl"},
            {"residual", "residual", "{:.1e}"},
            {"error_bound"},
            {"shape", "", "", Column::In::json}},
           static_cast<Index>(r.speeds.size()),
           [&](Index k) {
             const CriticalSpeed& s = r.speeds[static_cast<std::size_t>(k)];
             return std::vector<Cell>{
                 {k + 1},
                 {s.speed, determined(s.speed, s.error_bound)},
                 {s.speed * rpm, determined(s.speed * rpm, s.error_bound * rpm, 10)},
                 {s.whirl ? Json(to_string(*s.whirl)) : Json(nullptr), s.whirl ? std::string(to_string(*s.whirl)) : "–"},
                 {s.residual},
                 {s.error_bound},
                 {shape_json(model.labels(), s.shape)}};
           },
           true});
}

}  // namespace gyromode::io
