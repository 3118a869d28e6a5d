#pragma once

#include "accuracy.h"
#include "machine.h"
#include "rows.h"

#include <nlohmann/json_fwd.hpp>

namespace gyromode::bench {

/// Everything a run leaves behind.
struct Report {
  Machine machine;
  std::string revision;  ///< of the sources, as the caller gave it
  RowOptions options;
  std::vector<Row> rows;
  std::vector<Score> accuracy;
};

std::string text(const Machine& machine, const std::string& revision);
std::string text(const Row& row);
std::string text(const std::vector<Score>& league);

/// "gyromode/bench/1": all of it, every sample of every contestant included.
nlohmann::ordered_json json(const Report& report);

}  // namespace gyromode::bench
