#include "gyromode/write/document.h"
#include "gyromode/write/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

std::vector<std::string> evidence(const ModesResult& r) {
  std::vector<std::string> lines;
  Index largest = 0;
  for (const Component& c : r.structure.components) largest = std::max(largest, static_cast<Index>(c.coordinates.size()));
  if (largest > 0) lines.push_back(fmt::format("components: {}, of up to {} coordinates", r.structure.components.size(), largest));
  lines.push_back("solver: " + r.solver);
  if (!r.first_order) lines.push_back("index balance " + io::balance_words(r.index_balance));
  const Coverage& c = r.coverage;
  lines.push_back(fmt::format("window {}: found {}, counted {}", io::window_words(c.window), c.found,
                              c.counted ? fmt::format("{}", *c.counted) : "nothing"));
  double residual = 0, relative = 0;
  for (const Mode& m : r.modes) {
    residual = std::max(residual, m.residual);
    if (m.omega > 0) relative = std::max(relative, m.error_bound / m.omega);
  }
  if (!r.modes.empty())
    lines.push_back(fmt::format("largest residual {:.2g}, largest error bound {:.2g} of its frequency", residual, relative));
  if (std::isfinite(r.opposite_gap))
    lines.push_back(fmt::format("nearest roots of opposite energy sign: {:.3g} apart, relative", r.opposite_gap));
  return lines;
}

}  // namespace gyromode
