#pragma once

#include "gyromode/base/types.h"
#include "gyromode/base/labels.h"
#include "gyromode/system/symmetry.h"

#include <vector>

namespace gyromode {

/// A conservative system written in first order,
///     I q̇ + G q = 0,   I = Iᵀ > 0,   G = −Gᵀ,   real n × n
/// (Boland & Janssens 1979, third example, after Meirovitch 1974). With q = X e^{jωt}: H₁(ω) X = (ωI − jG) X = 0,
/// Hermitian.
class FirstOrderSystem {
 public:
  /// Labels default to q1 … qn; `admission` says how far the matrices may be from (skew-)symmetric. @throws LawBroken
  /// where a law is broken
  FirstOrderSystem(Matrix inertia, Matrix gyroscopic, Labels labels = {}, const Admission& admission = {});

  Index size() const { return inertia_.rows(); }                   ///< n
  const Matrix& inertia() const { return inertia_; }               ///< I, n × n, exactly symmetric
  const Matrix& gyroscopic() const { return gyroscopic_; }         ///< G, n × n, exactly skew
  const Labels& labels() const { return labels_; }                 ///< of the coordinates, n
  const std::vector<Repair>& repairs() const { return repairs_; }  ///< of the matrices given, those that needed one

  /// Other matrices in its place, an approximation of it: labels and repairs are taken over. Throws as the
  /// constructor.
  FirstOrderSystem replaced(Matrix inertia, Matrix gyroscopic) const;

  /// H₁(ω) = ωI − jG, Hermitian.
  ComplexMatrix impedance(double omega) const;

 private:
  Matrix inertia_;
  Matrix gyroscopic_;
  Labels labels_;
  std::vector<Repair> repairs_;
};

}  // namespace gyromode
