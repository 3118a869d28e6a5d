#pragma once

#include "gyromode/base/types.h"

namespace gyromode {

/// Displacements and velocities at one instant, in the order of the labels.
struct State {
  Vector q;     ///< displacements, n
  Vector qdot;  ///< velocities, n

  /// Nothing displaced, nothing moving.
  static State rest(Index n) { return {Vector::Zero(n), Vector::Zero(n)}; }
};

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
