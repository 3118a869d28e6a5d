#pragma once

#include "gyromode/base/types.h"
#include "gyromode/base/labels.h"

namespace gyromode {

/// A linear gyroscopic system about an equilibrium, in axes of the caller's choice,
///     M q̈ + G q̇ + K q = 0,   M = Mᵀ > 0,   G = −Gᵀ,   K = Kᵀ,   all real n × n
/// (Boland & Janssens 1979, Eq. 1). A System that exists keeps these promises; its matrices are exactly (skew-)symmetric.
/// Units are the caller's, but consistent: frequencies come out in rad per unit of time.
class System {
 public:
  /// Relative departures from symmetry found at the door, each within symmetry_tolerance.
  struct SymmetryErrors {
    double mass = 0, gyroscopic = 0, stiffness = 0;
  };

  /// Throws LawBroken where a promise does not hold. Labels default to q1 … qn.
  System(Matrix mass, Matrix gyroscopic, Matrix stiffness, Labels labels = {});

  Index size() const { return mass_.rows(); }
  const Matrix& mass() const { return mass_; }
  const Matrix& gyroscopic() const { return gyroscopic_; }
  const Matrix& stiffness() const { return stiffness_; }
  const Labels& labels() const { return labels_; }
  const SymmetryErrors& symmetry_errors() const { return symmetry_errors_; }

  /// Other matrices in its place, an approximation of it: labels and symmetry errors are taken over. Throws as the constructor.
  System replaced(Matrix mass, Matrix gyroscopic, Matrix stiffness) const;

  /// The impedance matrix H(ω) = K − ω²M + jωG, Hermitian (Eq. 4).
  ComplexMatrix impedance(double omega) const;

 private:
  Matrix mass_;
  Matrix gyroscopic_;
  Matrix stiffness_;
  Labels labels_;
  SymmetryErrors symmetry_errors_;
};

/// ½(A + Aᵀ) and ½(A − Aᵀ): for callers who want a matrix repaired and say so.
Matrix symmetric_part(const Matrix& a);
Matrix skew_part(const Matrix& a);

}  // namespace gyromode
