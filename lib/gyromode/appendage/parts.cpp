#include "gyromode/appendage/parts.h"
#include "gyromode/base/rounding.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode {

double Cable::first_moment() const { return tip_mass * reach() + 0.5 * line_density * length * (reach() + radius); }

double Cable::second_moment() const {
  const double b = reach();
  return tip_mass * b * b + line_density * length * (b * b + b * radius + radius * radius) / 3;
}

// Components that are rounding of right angles are zero.
Eigen::Vector3d Cable::direction() const {
  Eigen::Vector3d e(std::cos(azimuth), std::sin(azimuth), 0);
  for (double& x : e) {
    if (std::abs(x) <= 4 * epsilon) x = 0;
  }
  return e;
}

bool Cable::same_field(const Cable& o) const {
  return radius == o.radius && length == o.length && line_density == o.line_density && tip_mass == o.tip_mass;
}

std::string BoomPoint::name() const {
  if (part == Part::mass) return fmt::format("mass{}", number);
  return fmt::format("{}{}@{:g}", part == Part::cable ? "cable" : "beam", number, along);
}

}  // namespace gyromode
