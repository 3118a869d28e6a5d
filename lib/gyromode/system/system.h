#pragma once

#include "gyromode/base/types.h"
#include "gyromode/base/labels.h"
#include "gyromode/system/symmetry.h"

#include <vector>

namespace gyromode {

/// M, G, K of one order n, finite, exactly (skew-)symmetric, with a label for every coordinate; M of whatever sign.
struct AdmittedMatrices {
  Matrix mass;                  ///< M
  Matrix gyroscopic;            ///< G
  Matrix stiffness;             ///< K
  Labels labels;                ///< n
  std::vector<Repair> repairs;  ///< of those given
};

/// All laws of a System but M > 0. @throws LawBroken
AdmittedMatrices admitted(Matrix mass, Matrix gyroscopic, Matrix stiffness, Labels labels, const Admission& admission);

/// A linear gyroscopic system about an equilibrium, in axes of the caller's choice,
///     M q̈ + G q̇ + K q = 0,   M = Mᵀ > 0,   G = −Gᵀ,   K = Kᵀ,   all real n × n
/// (Boland & Janssens 1979, Eq. 1). A System that exists keeps these laws; its matrices are exactly (skew-)symmetric.
/// Units are the caller's, but consistent: frequencies come out in rad per unit of time.
class System {
 public:
  /// Labels default to q1 … qn; `admission` says how far the matrices may be from (skew-)symmetric. @throws LawBroken
  /// where a law is broken
  System(Matrix mass, Matrix gyroscopic, Matrix stiffness, Labels labels = {}, const Admission& admission = {});
  /// @throws LawBroken where M is not positive definite
  explicit System(AdmittedMatrices matrices);

  Index size() const { return of_.mass.rows(); }                      ///< n
  const Matrix& mass() const { return of_.mass; }                     ///< M, n × n, exactly symmetric
  const Matrix& gyroscopic() const { return of_.gyroscopic; }         ///< G, n × n, exactly skew
  const Matrix& stiffness() const { return of_.stiffness; }           ///< K, n × n, exactly symmetric
  const Labels& labels() const { return of_.labels; }                 ///< of the coordinates, n
  const std::vector<Repair>& repairs() const { return of_.repairs; }  ///< of the matrices given, those that needed one

  /// Other matrices in its place, an approximation of it: labels and repairs are taken over. Throws as the
  /// constructor.
  System replaced(Matrix mass, Matrix gyroscopic, Matrix stiffness) const;

  /// The impedance matrix H(ω) = K − ω²M + jωG, Hermitian (Eq. 4).
  ComplexMatrix impedance(double omega) const;

 private:
  AdmittedMatrices of_;
};

}  // namespace gyromode
