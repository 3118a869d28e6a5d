#pragma once

#include "gyromode/base/types.h"
#include "gyromode/base/labels.h"
#include "gyromode/system/symmetry.h"

#include <vector>

namespace gyromode {

/// A linear gyroscopic system about an equilibrium, in axes of the caller's choice,
///     M q̈ + G q̇ + K q = 0,   M = Mᵀ > 0,   G = −Gᵀ,   K = Kᵀ,   all real n × n
/// (Boland & Janssens 1979, Eq. 1). A System that exists keeps these laws; its matrices are exactly (skew-)symmetric.
/// Units are the caller's, but consistent: frequencies come out in rad per unit of time.
class System {
 public:
  /// Labels default to q1 … qn; `admission` says how far the matrices may be from (skew-)symmetric. @throws LawBroken
  /// where a law is broken
  System(Matrix mass, Matrix gyroscopic, Matrix stiffness, Labels labels = {}, const Admission& admission = {});

  Index size() const { return mass_.rows(); }                      ///< n
  const Matrix& mass() const { return mass_; }                     ///< M, n × n, exactly symmetric
  const Matrix& gyroscopic() const { return gyroscopic_; }         ///< G, n × n, exactly skew
  const Matrix& stiffness() const { return stiffness_; }           ///< K, n × n, exactly symmetric
  const Labels& labels() const { return labels_; }                 ///< of the coordinates, n
  const std::vector<Repair>& repairs() const { return repairs_; }  ///< of the matrices given, those that needed one

  /// Other matrices in its place, an approximation of it: labels and repairs are taken over. Throws as the
  /// constructor.
  System replaced(Matrix mass, Matrix gyroscopic, Matrix stiffness) const;

  /// The impedance matrix H(ω) = K − ω²M + jωG, Hermitian (Eq. 4).
  ComplexMatrix impedance(double omega) const;

 private:
  Matrix mass_;
  Matrix gyroscopic_;
  Matrix stiffness_;
  Labels labels_;
  std::vector<Repair> repairs_;
};

}  // namespace gyromode
