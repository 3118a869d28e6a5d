#pragma once

#include "gyromode/base/types.h"

#include <string_view>

namespace gyromode {

/// Displacements and velocities at one instant, in the order of the labels.
struct State {
  Vector q;     ///< displacements, n
  Vector qdot;  ///< velocities, n

  /// Nothing displaced, nothing moving.
  static State rest(Index n) { return {Vector::Zero(n), Vector::Zero(n)}; }
};

/// Throws InvalidArgument unless they are n finite numbers; `what` they are.
void require_coordinates(const Vector& v, Index n, std::string_view what);
/// Throws InvalidArgument unless t ≥ 0 and finite: motions begin at 0.
void require_time(double t);

/// A force f·u(t) on the coordinates, from t = 0 on: M q̈ + G q̇ + K q = f u(t).
struct Force {
  /// How it goes over time.
  enum class Course {
    impulse,   ///< u = δ(t): q̇ jumps by M⁻¹f
    step,      ///< u = 1
    harmonic,  ///< u = cos(frequency · t)
  };
  Course course = Course::step;  ///< u
  Vector amplitude;              ///< f, n
  double frequency = 0;          ///< rad per unit of time, of a harmonic one
};

}  // namespace gyromode
