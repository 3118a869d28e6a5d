#include "gyromode/base/error.h"
#include "gyromode/models/model.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/models/parameter_keys.h"

#include <algorithm>

namespace gyromode {

bool CriticalMap::has_a_model() const {
  return std::any_of(rows.begin(), rows.end(), [](const Row& r) { return r.reason.empty(); });
}

bool CriticalMap::is_complete() const {
  return !interrupted && std::all_of(rows.begin(), rows.end(), [](const Row& r) {
    return !r.reason.empty() || r.speeds.coverage.status == CoverageStatus::complete;
  });
}

CriticalMap Model::critical_speeds_over(const ParameterAxis& axis, const CriticalOptions& options, const Progress& progress) const {
  require_parameter(*body, axis.keys);
  CriticalMap map;
  map.keys = axis.keys;
  for (const double value : axis.values) {
    if (progress.stopped()) {
      if (map.rows.empty()) throw Interrupted();
      map.interrupted = true;
      break;
    }
    CriticalMap::Row row;
    row.value = value;
    std::vector<ParameterValue> values;
    for (const std::string& key : keys_of(axis.keys)) values.push_back({key, value});
    try {
      row.speeds = with(values).critical_speeds(options);
    } catch (const LawBroken& e) {
      row.reason = e.what();
    } catch (const Unreadable& e) {  // a formula that is no number there
      row.reason = e.what();
    }
    map.rows.push_back(std::move(row));
    progress.report("values", static_cast<Index>(map.rows.size()), static_cast<Index>(axis.values.size()));
  }
  return map;
}

}  // namespace gyromode
