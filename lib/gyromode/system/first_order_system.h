#pragma once

#include "gyromode/base/types.h"
#include "gyromode/base/labels.h"

namespace gyromode {

/// A conservative system written in first order,
///     I q̇ + G q = 0,   I = Iᵀ > 0,   G = −Gᵀ,   real n × n
/// (Boland & Janssens 1979, third example, after Meirovitch 1974). With q = X e^{jωt}: H₁(ω) X = (ωI − jG) X = 0,
/// Hermitian.
class FirstOrderSystem {
 public:
  /// Relative departures from symmetry found at the door, each within 16 ε.
  struct SymmetryErrors {
    double inertia = 0;     ///< of I
    double gyroscopic = 0;  ///< of G
  };

  /// Throws LawBroken where a law is broken. Labels default to q1 … qn.
  FirstOrderSystem(Matrix inertia, Matrix gyroscopic, Labels labels = {});

  Index size() const { return inertia_.rows(); }                              ///< n
  const Matrix& inertia() const { return inertia_; }                          ///< I, n × n, exactly symmetric
  const Matrix& gyroscopic() const { return gyroscopic_; }                    ///< G, n × n, exactly skew
  const Labels& labels() const { return labels_; }                            ///< of the coordinates, n
  const SymmetryErrors& symmetry_errors() const { return symmetry_errors_; }  ///< of the matrices given

  /// Other matrices in its place, an approximation of it: labels and symmetry errors are taken over. Throws as the
  /// constructor.
  FirstOrderSystem replaced(Matrix inertia, Matrix gyroscopic) const;

  /// H₁(ω) = ωI − jG, Hermitian.
  ComplexMatrix impedance(double omega) const;

 private:
  Matrix inertia_;
  Matrix gyroscopic_;
  Labels labels_;
  SymmetryErrors symmetry_errors_;
};

}  // namespace gyromode
