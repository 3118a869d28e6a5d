#pragma once

#include "gyromode/sparse/groups.h"
#include "gyromode/sparse/shifted.h"

namespace gyromode {

/// H(ω)⁻¹f of a sparse system, by one factorisation a frequency; in the coordinates that the system is written in.
class SteadySolver {
 public:
  explicit SteadySolver(const SparseSystem& system);

  /// q of H(ω)q = f, with one step of refinement, where H is regular. n
  ComplexVector at(double omega, const ComplexVector& force) const;
  /// The mean of both sides of a mode that f does not drive; of ω = 0, where q(−ω) is the conjugate of q(ω), its real
  /// part.
  ComplexVector beside(double omega, const ComplexVector& force) const;
  /// H(ω), factored. The last two are kept.
  std::shared_ptr<const sparse::ShiftedFactor> factored(double omega) const { return impedance_.at(omega); }

  /// Kq, Mq and jGq.
  struct Products {
    ComplexVector k, m, jg;  ///< n
    /// H(ω)q.
    ComplexVector at(double omega) const { return k - (omega * omega) * m + omega * jg; }
  };
  Products products(const ComplexVector& q) const;
  /// M⁻¹f. n. @throws NotApplicable where M is singular
  Vector accelerations(const Vector& force) const;
  /// √(fᵀM⁻¹f); where M is singular, of its diagonal.
  double size_of(const Vector& force) const;

 private:
  const SparseSystem& system_;
  sparse::Groups groups_;
  sparse::ShiftedImpedance impedance_;
};

}  // namespace gyromode
