#pragma once

#include "gyromode/roots/couplings.h"
#include "gyromode/roots/lifted.h"

namespace gyromode {

/// Something whose modes are the null vectors of a Lifted matrix. Frequencies are relative to a unit of its choice, in
/// which its matrices are of order 1.
class LiftedImpedance {
 public:
  virtual ~LiftedImpedance() = default;

  virtual Index size() const = 0;
  virtual Couplings couplings() const = 0;            ///< of all frequencies
  virtual Lifted at(double omega) const = 0;          ///< Hermitian; ω > 0, or the limit 0⁺
  virtual ComplexMatrix at(Complex omega) const = 0;  ///< analytic continuation; growth rate −Im ω
  /// Relative rounding of the entries at ω: n ε, and what the phase of the fields costs.
  virtual double rounding(double omega) const = 0;
};

}  // namespace gyromode
