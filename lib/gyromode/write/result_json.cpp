#include "gyromode/write/result_json.h"

#include "gyromode/write/json_parts.h"

namespace gyromode::io {

namespace {

// Points at rest, and the lines through them. Where each mode takes them stands with the mode.
Json geometry(const ModesResult& r) {
  if (r.outlines.empty()) return nullptr;
  Json points = Json::array(), lines = Json::array();
  for (const ModelOutline& o : r.outlines) {
    Json through = Json::array();
    for (const Eigen::Vector3d& p : o.points) {
      through.push_back(points.size());
      points.push_back({p(0), p(1), p(2)});
    }
    lines.push_back({{"name", o.name}, {"points", std::move(through)}});
  }
  return {{"points", std::move(points)}, {"lines", std::move(lines)}, {"displacements", "modes[].displacements"}};
}

}  // namespace

std::string modes_json(const Model& model, const ModesResult& r, const Timings& timings) {
  Json j = head("gyromode/modes/1", model, timings);
  j["structure"] = structure_facts(model, r.structure, r.stiffness, !r.first_order);
  j["structure"]["path"] = r.solver;
  j["stability"] = gyromode::to_string(r.stability);
  j["index_balance"] = balance_json(r.index_balance);
  const Coverage& c = r.coverage;
  j["coverage"] = {{"status", gyromode::to_string(c.status)}, {"window", bounds(c.window)}, {"requested", bounds(c.requested)}, {"found", c.found},
                   {"counted", c.counted ? Json(*c.counted) : Json(nullptr)}};
  if (!c.reason.empty()) j["coverage"]["reason"] = c.reason;
  if (c.interrupted) j["interrupted"] = true;
  j["modes"] = modes_array(model, r.modes);
  j["unstable"] = unstable_array(model, r.unstable);
  j["geometry"] = geometry(r);  // a matrix model has none
  return text(j);
}

std::string count_json(const Model& model, const CountResult& r, const Timings& timings) {
  Json j = head("gyromode/count/1", model, timings);
  j["window"] = bounds(r.window);
  j["requested"] = bounds(r.requested);
  j["count"] = r.count ? Json(*r.count) : Json(nullptr);
  j["signed"] = r.signed_count;
  j["zero"] = r.zero;
  j["negative"] = r.negative;
  j["status"] = gyromode::to_string(r.status);
  return text(j);
}

}  // namespace gyromode::io
