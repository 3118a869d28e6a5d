#include "gyromode/write/json_parts.h"
#include "gyromode/write/result_json.h"

namespace gyromode::io {

namespace {

Json verdict(const StabilityPoint& p) { return p.law_kept ? Json(gyromode::to_string(p.stability)) : Json(nullptr); }

void add_motions(const StabilityPoint& p, Json& to) {
  to["real_pairs"] = p.balance.real_pairs;
  to["quadruples"] = p.balance.quadruples;
  to["negative_energy"] = p.balance.negative_energy;
}

void add_map(const StabilityReport& r, Json& j) {
  j["varied"] = r.varied;
  j["map"] = Json::array();
  for (const auto& [values, p] : r.map->cells) {
    Json cell{{"values", values}, {"stability", verdict(p)}, {"growth_rate", p.growth_rate}};
    add_motions(p, cell);
    if (!p.reason.empty()) cell["reason"] = p.reason;
    j["map"].push_back(std::move(cell));
  }
  j["critical"] = Json::array();
  for (const CriticalValue& c : r.map->critical) {
    Json one{{"key", r.varied[c.axis]}, {"value", c.value}, {"bracket", {c.lo, c.hi}}, {"from", verdict(c.from)}, {"to", verdict(c.to)}};
    add_motions(c.from, one["motions"]["from"]);
    add_motions(c.to, one["motions"]["to"]);
    for (std::size_t k = 0; k < c.others.size(); ++k) one["at"][r.varied[k + 1]] = c.others[k];
    j["critical"].push_back(std::move(one));
  }
  if (r.map->interrupted) j["interrupted"] = true;
  j["evaluations"] = {{"cells", r.map->cells.size()}, {"between", r.map->evaluations}};
}

}  // namespace

std::string stability_json(const Model& model, const StabilityReport& report, const Timings& timings) {
  const ModesResult& r = report.result;
  Json j = head("gyromode/stability/1", model, timings);
  j["stability"] = gyromode::to_string(r.stability);
  j["index_balance"] = balance_json(r.index_balance);
  j["unstable"] = unstable_array(model, r.unstable);
  j["negative_modes"] = modes_array(model, r.negative_modes);
  j["margin"] = {{"opposite_sign_gap", number(r.opposite_gap)}, {"opposite_pair", report.opposite ? Json(*report.opposite) : Json(nullptr)},
                 {"stiffness", report.stiffness ? Json(*report.stiffness) : Json(nullptr)}};
  if (!r.first_order) {
    Json destabilised = Json::array();
    for (const Mode& m : r.negative_modes) destabilised.push_back(m.omega);
    j["damping"] = {{"growing_roots", r.index_balance.negative}, {"destabilised", std::move(destabilised)}};
  }
  if (report.map) add_map(report, j);
  return text(j);
}

}  // namespace gyromode::io
