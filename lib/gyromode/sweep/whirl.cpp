#include "gyromode/sweep/whirl.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyromode {

std::string_view to_string(Whirl whirl) {
  switch (whirl) {
    case Whirl::forward: return "forward";
    case Whirl::backward: return "backward";
    case Whirl::mixed: return "mixed";
    case Whirl::degenerate: return "degenerate";
    default: return "planar";
  }
}

// x + jy = p e^{jωt} + q̄ e^{−jωt}, p = (X + jY)/2, q = (X − jY)/2.
Orbit orbit_of(const ComplexVector& shape, const OrbitCoordinates& place) {
  const Complex j(0, 1), p = 0.5 * (shape(place.x) + j * shape(place.y)), q = 0.5 * (shape(place.x) - j * shape(place.y));
  double inclination = 0.5 * (std::arg(p) - std::arg(q));
  if (inclination > 0.5 * std::numbers::pi) inclination -= std::numbers::pi;
  if (inclination <= -0.5 * std::numbers::pi) inclination += std::numbers::pi;
  return {std::abs(p) + std::abs(q), std::abs(p) - std::abs(q), inclination};
}

Whirl Orbit::whirl(double spin) const {
  constexpr double small = 1e-6;
  return std::abs(minor) <= small * major ? Whirl::planar : (minor > 0) == (spin >= 0) ? Whirl::forward : Whirl::backward;
}

std::vector<FixedAxesPart> in_fixed_axes(const ComplexVector& shape, double omega, double spin,
                                         const std::vector<OrbitCoordinates>& places) {
  constexpr double small = 1e-6;
  const Complex j(0, 1);
  double with = 0, against = 0;  // squares of p and q
  for (const OrbitCoordinates& at : places) {
    with += std::norm(shape(at.x) + j * shape(at.y)) / 4;
    against += std::norm(shape(at.x) - j * shape(at.y)) / 4;
  }
  const double largest = std::max(with, against), sense = spin < 0 ? -1 : 1;
  std::vector<FixedAxesPart> all;
  if (!(largest > small * small * shape.squaredNorm())) return all;
  if (with > small * small * largest) all.push_back({sense * (spin + omega), with / (with + against)});
  if (against > small * small * largest) all.push_back({sense * (spin - omega), against / (with + against)});
  return all;
}

std::optional<Whirl> whirl_of(const ComplexVector& shape, const std::vector<OrbitCoordinates>& places, double spin) {
  if (places.empty()) return std::nullopt;
  constexpr double small = 1e-6;
  double largest = 0;
  for (const OrbitCoordinates& p : places) largest = std::max(largest, std::norm(shape(p.x)) + std::norm(shape(p.y)));
  if (!(largest > small * small * shape.squaredNorm())) return std::nullopt;
  bool forward = false, backward = false;
  for (const OrbitCoordinates& p : places) {
    if (!(std::norm(shape(p.x)) + std::norm(shape(p.y)) > small * small * largest)) continue;
    const Whirl whirl = orbit_of(shape, p).whirl(spin);
    forward = forward || whirl == Whirl::forward;
    backward = backward || whirl == Whirl::backward;
  }
  if (forward && backward) return Whirl::mixed;
  return forward ? Whirl::forward : backward ? Whirl::backward : Whirl::planar;
}

}  // namespace gyromode
