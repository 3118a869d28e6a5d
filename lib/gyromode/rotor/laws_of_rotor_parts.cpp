#include "gyromode/rotor/rotor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

std::optional<BrokenLaw> stiffness(const char* key, double value) {
  if (value >= 0) return std::nullopt;  // inf pins
  return BrokenLaw{key, fmt::format("'{}' must not be below 0 (inf: pinned): it is {:.6g}", key, value)};
}

std::optional<BrokenLaw> coupled(const char* key, double value, double a, double b) {
  if (const auto broken = not_a_finite_number(key, value)) return broken;
  if (value == 0 || (std::isfinite(a) && std::isfinite(b))) return std::nullopt;
  return BrokenLaw{key, fmt::format("'{}' must be 0 where one of the two directions is pinned: it is {:.6g}", key, value)};
}

std::optional<BrokenLaw> ring(double inner, double outer) {
  if (inner < outer) return std::nullopt;
  return BrokenLaw{"inner_diameter", fmt::format("'inner_diameter' must be below the outer one: {:.6g} m ≥ {:.6g} m", inner, outer)};
}

}  // namespace

std::optional<BrokenLaw> broken_law(const Material& m) {
  if (const auto b = first_broken(
          {not_positive("young", "Pa", m.young), not_positive("shear", "Pa", m.shear), not_positive("density", "kg/m³", m.density)}))
    return b;
  if (m.poisson() > -1 && m.poisson() <= 0.5 + 1e-9) return std::nullopt;
  return BrokenLaw{"shear", fmt::format("'shear' must leave Poisson's ratio E/2G − 1 between −1 and 0.5: it is {:.6g}", m.poisson())};
}

std::optional<BrokenLaw> broken_law(const ShaftSection& s) {
  constexpr Index most = 2000;
  if (const auto b = first_broken({not_positive("length", "m", s.length),
                                   not_positive("outer_diameter", "m", std::min(s.outer_diameter[0], s.outer_diameter[1])),
                                   not_a_finite_number("outer_diameter", s.outer_diameter[0] + s.outer_diameter[1]),
                                   negative("inner_diameter", "m", std::min(s.inner_diameter[0], s.inner_diameter[1])),
                                   ring(s.inner_diameter[0], s.outer_diameter[0]), ring(s.inner_diameter[1], s.outer_diameter[1])}))
    return b;
  if (s.shear_coefficient) {
    if (const auto b = not_positive("shear_coefficient", "", *s.shear_coefficient)) return b;
  }
  if (s.elements >= 1 && s.elements <= most) return std::nullopt;
  return BrokenLaw{"elements", fmt::format("'elements' must be from 1 to {}: it is {}", most, s.elements)};
}

std::optional<BrokenLaw> broken_law(const Disc& d) {
  if (const auto b = first_broken({not_a_finite_number("position", d.position), not_a_finite_number("offset", d.offset)})) return b;
  if (d.geometry) {
    const DiscGeometry& g = *d.geometry;
    return first_broken({not_positive("width", "m", g.width), not_positive("outer_diameter", "m", g.outer_diameter),
                         negative("inner_diameter", "m", g.inner_diameter), ring(g.inner_diameter, g.outer_diameter)});
  }
  if (const auto b = first_broken({negative("mass", "kg", d.mass), negative("polar_inertia", "kg m²", d.polar_inertia),
                                   negative("diametral_inertia", "kg m²", d.diametral_inertia)}))
    return b;
  constexpr double as_printed = 1e-3;  // what data of few digits leave
  if (d.polar_inertia <= 2 * d.diametral_inertia * (1 + as_printed)) return std::nullopt;
  return BrokenLaw{
      "polar_inertia",
      fmt::format(
          "'polar_inertia' must obey the triangle inequality, at most twice the diametral one (of a thin disc): {:.6g} > 2 · {:.6g} kg m²",
          d.polar_inertia, d.diametral_inertia)};
}

std::optional<BrokenLaw> broken_law(const Bearing& b) {
  if (const auto broken =
          first_broken({not_a_finite_number("position", b.position), stiffness("kxx", b.kxx), stiffness("kyy", b.kyy),
                        coupled("kxy", b.kxy, b.kxx, b.kyy), stiffness("tilt_xx", b.tilt_xx), stiffness("tilt_yy", b.tilt_yy),
                        coupled("tilt_xy", b.tilt_xy, b.tilt_xx, b.tilt_yy), negative("housing_mass", "kg", b.housing_mass),
                        negative("housing_kxx", "N/m", b.housing_kxx), negative("housing_kyy", "N/m", b.housing_kyy)}))
    return broken;
  if (b.has_housing() && !b.to.empty())
    return BrokenLaw{"to", "a bearing between two spools has no housing on the ground: leave out 'to' or the housing"};
  if (b.to.empty() || b.to != b.spool) return std::nullopt;
  return BrokenLaw{"to", fmt::format("'to' must be another spool than the one that the bearing is on, '{}'", b.spool)};
}

std::optional<BrokenLaw> broken_law(const PointMass& m) {
  return first_broken({not_a_finite_number("position", m.position), negative("mass", "kg", m.mass)});
}

std::optional<BrokenLaw> broken_law(const Spool& s) {
  return first_broken({not_a_finite_number("speed_ratio", s.speed_ratio), not_a_finite_number("start", s.start)});
}

}  // namespace gyromode
