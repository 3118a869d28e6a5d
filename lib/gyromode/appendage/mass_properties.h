#pragma once

#include "gyromode/base/types.h"

namespace gyromode {

/// Mass m, first moment ∫ p dm and second moment ∫ p pᵀ dm of something frozen in its steady place, about the origin of
/// the heights.
struct MassProperties {
  double mass = 0;                                   ///< m, kg
  Eigen::Vector3d first = Eigen::Vector3d::Zero();   ///< ∫ p dm, kg m
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< ∫ p pᵀ dm, kg m²

  /// Of a point, or of a body with the inertia tensor `central` about its own centre of mass.
  static MassProperties point(double mass, const Eigen::Vector3d& p) { return {mass, mass * p, mass * p * p.transpose()}; }
  /// Of a body with the inertia tensor `central` about its own centre of mass, which is the origin.
  static MassProperties body(double mass, const Eigen::Matrix3d& central) {
    return {mass, Eigen::Vector3d::Zero(), 0.5 * central.trace() * Eigen::Matrix3d::Identity() - central};
  }

  /// Of both together.
  MassProperties& operator+=(const MassProperties& o) {
    mass += o.mass;
    first += o.first;
    second += o.second;
    return *this;
  }
  /// About a point at `height` on axis 3.
  MassProperties seen_from(double height) const;
  /// Inertia tensor ∫ (|p|² 1 − p pᵀ) dm; its off-diagonal entries are −∫ xy dm ….
  Eigen::Matrix3d inertia() const { return second.trace() * Eigen::Matrix3d::Identity() - second; }
};

}  // namespace gyromode
