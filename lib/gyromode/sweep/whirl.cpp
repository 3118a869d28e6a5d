#include "gyromode/sweep/whirl.h"

#include <algorithm>
#include <cmath>

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

// The area of the orbit is −π Im(X̄Y): positive with the rotation.
std::optional<Whirl> whirl_of(const ComplexVector& shape, const std::vector<OrbitCoordinates>& places) {
  if (places.empty()) return std::nullopt;
  constexpr double small = 1e-6;
  double largest = 0;
  for (const OrbitCoordinates& p : places) largest = std::max(largest, std::norm(shape(p.x)) + std::norm(shape(p.y)));
  if (!(largest > small * small * shape.squaredNorm())) return std::nullopt;
  bool forward = false, backward = false;
  for (const OrbitCoordinates& p : places) {
    const double size = std::norm(shape(p.x)) + std::norm(shape(p.y)), area = -2 * std::imag(std::conj(shape(p.x)) * shape(p.y));
    if (!(size > small * small * largest) || std::abs(area) <= small * size) continue;
    (area > 0 ? forward : backward) = true;
  }
  if (forward && backward) return Whirl::mixed;
  return forward ? Whirl::forward : backward ? Whirl::backward : Whirl::planar;
}

}  // namespace gyromode
