#include "response_options.h"

#include "errors.h"
#include "load.h"

#include "gyromode/models/model_kind.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode::app {

namespace {

bool large(const Model& m) { return !m.body->finite() && !m.body->transcendental(); }

}  // namespace

std::vector<Index> chosen_of(const ResponseOptions& o, const Model& m, const std::vector<const Vector*>& driving) {
  if (!o.only.empty()) return coordinates_of("--only", o.only, m.labels());
  if (!large(m)) return {};
  constexpr std::size_t most = 200;
  std::vector<Index> driven;
  for (Index i = 0; i < m.size(); ++i) {
    if (std::any_of(driving.begin(), driving.end(), [&](const Vector* v) { return (*v)(i) != 0; })) driven.push_back(i);
  }
  if (driven.empty() || driven.size() > most)
    throw UsageError(fmt::format("which of the {} coordinates are wanted? --only LABEL,LABEL,… names them", m.size()));
  o.output.say(fmt::format("shown are what is driven, {} of {} coordinates: --only LABEL,LABEL,… names others", driven.size(), m.size()));
  return driven;
}

void choose_modes(const ResponseOptions& o, const Model& m, MotionRequest& request) {
  if (!large(m)) {
    if (o.window.given() || o.lowest)
      throw UsageError("--lowest, --below and --window are for large sparse models: this motion is made of all modes");
    return;
  }
  request.window = o.window.read();
  request.lowest = o.window.given() ? o.lowest : o.lowest.value_or(lowest_by_default);
  if (o.window.given() && request.window.open())
    throw UsageError("--window: a large sparse model is searched window by window; the upper end is needed");
}

}  // namespace gyromode::app
