#pragma once

#include "input.h"
#include "output.h"

#include "gyromode/models/model.h"

#include <optional>
#include <string>
#include <vector>

namespace gyromode::app {

/// What the verb `response` is asked.
struct ResponseOptions {
  ModelSource source;
  OutputOption output;
  WindowOption window;
  std::optional<Index> lowest;
  std::string initial, times, frequencies, only;
  std::optional<std::string> until, step;
  std::vector<std::string> forces, points, unbalances;
  std::string spin;
  bool rates = false;
};

/// The coordinates of --only; of a large sparse model otherwise those that something drives. Throws UsageError.
std::vector<Index> chosen_of(const ResponseOptions& o, const Model& m, const std::vector<const Vector*>& driving);

/// A motion of a large sparse model is made of some of its modes; of others all take part. Throws UsageError.
void choose_modes(const ResponseOptions& o, const Model& m, MotionRequest& request);

}  // namespace gyromode::app
