#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode {

/// A linear form on the coordinates with few entries: Σ value · q(index).
struct LinearForm {
  std::vector<Index> index;
  std::vector<double> value;

  void add(Index i, double v) {
    index.push_back(i);
    value.push_back(v);
  }
};

/// M, G, K of small motion about steady rotation Ω about axis 3, summed from energies. Coordinates: ζ (3), θ (3), then
/// those of the flexible parts.
///
/// A mass point at p with displacement r₁ = ζ + θ × p + u relative to turning axes, first order, and r₂ = ½θ × (θ × p)
/// + θ × u + f, second order (f: foreshortening), has
///     L = ½m|ṙ₁ + Ω × r₁|² + mΩ² (Pp)·r₂,   P = diag(1, 1, 0);
/// nothing else is used: no field equation, no impedance.
class QuadraticEnergy {
 public:
  explicit QuadraticEnergy(Index coordinates, double spin);

  /// A mass point; u a linear form for each axis (empty: fixed to the body).
  void add_point(double mass, const Eigen::Vector3d& p, const LinearForm (&u)[3]);
  void add_point(double mass, const Eigen::Vector3d& p);
  /// Potential energy ½ weight (form)².
  void add_stiffness(double weight, const LinearForm& form);

  const Matrix& mass() const { return m_; }
  const Matrix& gyroscopic() const { return g_; }
  const Matrix& stiffness() const { return k_; }

 private:
  double spin_;
  Matrix m_, g_, k_;
};

}  // namespace gyromode
