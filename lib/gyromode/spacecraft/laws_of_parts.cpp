#include "gyromode/spacecraft/spacecraft.h"

#include "gyromode/lapack/small.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode {

namespace {

std::optional<BrokenLaw> law_of_inertia(const Eigen::Matrix3d& j) {
  constexpr double rounding = 1e-12;
  if (!j.allFinite()) return BrokenLaw{"inertia", "'inertia' must be finite"};
  const double size = j.cwiseAbs().maxCoeff();
  for (Index i = 0; i < 3; ++i) {
    for (Index k = 0; k < i; ++k) {
      if (std::abs(j(i, k) - j(k, i)) > rounding * size) {
        return BrokenLaw{"inertia", fmt::format("'inertia' must be symmetric: entries ({},{}) = {:.6g} and ({},{}) = {:.6g} differ", k + 1,
                                                i + 1, j(k, i), i + 1, k + 1, j(i, k))};
      }
    }
  }
  const Eigen::Vector3d principal = small::symmetric_eigenvalues(j);
  if (!(principal(0) > 0))
    return BrokenLaw{"inertia",
                     fmt::format("'inertia' must be positive definite: its smallest principal moment is {:.6g} kg m²", principal(0))};
  if (principal(2) > (principal(0) + principal(1)) * (1 + rounding)) {
    return BrokenLaw{"inertia", fmt::format("'inertia' must obey the triangle inequality, no principal moment above the sum of the others: "
                                            "{:.10g} > {:.10g} + {:.10g} kg m²",
                                            principal(2), principal(0), principal(1))};
  }
  return std::nullopt;
}

}  // namespace

std::optional<BrokenLaw> broken_law(const Body& b) { return first_broken({not_positive("mass", "kg", b.mass), law_of_inertia(b.inertia)}); }

std::optional<BrokenLaw> broken_law(const Cable& c) {
  return first_broken({not_a_finite_number("azimuth", c.azimuth), negative("radius", "m", c.radius),
                       not_a_finite_number("height", c.height), not_positive("length", "m", c.length),
                       not_positive("line_density", "kg/m", c.line_density), negative("tip_mass", "kg", c.tip_mass)});
}

std::optional<BrokenLaw> broken_law(const Beam& b) {
  return first_broken({not_a_finite_number("root", b.root_height), not_positive("length", "m", b.length),
                       not_positive("line_density", "kg/m", b.line_density),
                       not_positive("bending_stiffness", "N m²", std::min(b.bending_stiffness[0], b.bending_stiffness[1])),
                       negative("tip_mass", "kg", b.tip_mass)});
}

std::optional<BrokenLaw> broken_law(const SpringMass& m) {
  if (const auto b = first_broken({not_a_finite_number("position", m.position.sum()), not_positive("mass", "kg", m.mass)})) return b;
  for (Index i = 0; i < 3; ++i) {
    if (!(m.stiffness(i) > 0)) {
      return BrokenLaw{
          "stiffness",
          fmt::format("'stiffness' must be above 0 (inf: rigid), or nothing holds the mass to the body: along axis {} it is {:.6g} N/m",
                      i + 1, m.stiffness(i))};
    }
  }
  return std::nullopt;
}

}  // namespace gyromode
