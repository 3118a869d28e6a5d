#pragma once

#include "gyromode/base/types.h"
#include "gyromode/base/labels.h"

namespace gyromode {

/// A linear gyroscopic system about an equilibrium, in axes of the caller's choice,
///     M q̈ + G q̇ + K q = 0,   M = Mᵀ > 0,   G = −Gᵀ,   K = Kᵀ,   all real n × n
/// (Boland & Janssens 1979, Eq. 1). A System that exists keeps these laws; its matrices are exactly (skew-)symmetric.
/// Units are the caller's, but consistent: frequencies come out in rad per unit of time.
class System {
 public:
  /// Relative departures from symmetry found at the door, each within symmetry_tolerance.
  struct SymmetryErrors {
    double mass = 0;        ///< of M
    double gyroscopic = 0;  ///< of G
    double stiffness = 0;   ///< of K
  };

  /// Throws LawBroken where a law is broken. Labels default to q1 … qn.
  System(Matrix mass, Matrix gyroscopic, Matrix stiffness, Labels labels = {});

  Index size() const { return mass_.rows(); }                                 ///< n
  const Matrix& mass() const { return mass_; }                                ///< M, n × n, exactly symmetric
  const Matrix& gyroscopic() const { return gyroscopic_; }                    ///< G, n × n, exactly skew
  const Matrix& stiffness() const { return stiffness_; }                      ///< K, n × n, exactly symmetric
  const Labels& labels() const { return labels_; }                            ///< of the coordinates, n
  const SymmetryErrors& symmetry_errors() const { return symmetry_errors_; }  ///< of the matrices given

  /// Other matrices in its place, an approximation of it: labels and symmetry errors are taken over. Throws as the
  /// constructor.
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
