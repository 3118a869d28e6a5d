#include "gyromode/io/json_parts.h"
#include "gyromode/io/result_json.h"

namespace gyromode::io {

std::string stability_json(const Model& model, const ModesResult& r, const Timings& timings) {
  Json j = head("gyromode/stability/1", model, timings);
  j["stability"] = gyromode::word(r.stability);
  j["index_balance"] = balance_json(r.index_balance);
  j["unstable"] = unstable_array(r.unstable);
  j["negative_modes"] = modes_array(model, r.negative_modes);
  j["margin"] = {{"opposite_sign_gap", number(r.opposite_gap)}};
  return text(j);
}

}  // namespace gyromode::io
