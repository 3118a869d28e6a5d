#include "gyromode/sweep/quarter_turn.h"

#include <cmath>

namespace gyromode {

namespace {

bool commutes(const Matrix& a, const std::vector<OrbitCoordinates>& pairs) {
  if (a.size() == 0) return true;
  for (const OrbitCoordinates& p : pairs) {
    for (const OrbitCoordinates& q : pairs) {
      if (a(p.x, q.x) != a(p.y, q.y) || a(p.x, q.y) != -a(p.y, q.x)) return false;
    }
  }
  return true;
}

}  // namespace

bool QuarterTurn::is_symmetry_of(const SpinFamily& f) const {
  std::vector<int> named(static_cast<std::size_t>(f.mass.rows()), 0);
  for (const OrbitCoordinates& p : pairs_) {
    ++named[static_cast<std::size_t>(p.x)];
    ++named[static_cast<std::size_t>(p.y)];
  }
  for (const int times : named) {
    if (times != 1) return false;
  }
  return commutes(f.mass, pairs_) && commutes(f.gyroscopic, pairs_) && commutes(f.gyroscopic_per_spin, pairs_) &&
         commutes(f.stiffness, pairs_) && commutes(f.stiffness_per_spin2, pairs_);
}

// (JX)_x = −X_y, (JX)_y = X_x.
std::optional<int> QuarterTurn::sense_of(const ComplexVector& x, double tolerance) const {
  const Complex j(0, 1);
  double forward = 0, backward = 0, all = 0;
  for (const OrbitCoordinates& p : pairs_) {
    forward += std::norm(x(p.y) + j * x(p.x));
    backward += std::norm(x(p.y) - j * x(p.x));
    all += std::norm(x(p.x)) + std::norm(x(p.y));
  }
  const double limit = tolerance * tolerance * all;
  if (forward <= limit) return 1;
  if (backward <= limit) return -1;
  return std::nullopt;
}

}  // namespace gyromode
