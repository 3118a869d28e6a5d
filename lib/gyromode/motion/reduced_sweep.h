#pragma once

#include "gyromode/motion/steady_solver.h"

namespace gyromode {

/// H(ω)⁻¹f of one force over many frequencies: a Galerkin projection on the modes of the range and on what earlier
/// frequencies needed, corrected by the factors of H at one of them. What the correction leaves is the error: where it
/// does not go below 10⁻¹¹ of q after some steps H is factored there.
class ReducedSweep {
 public:
  /// `shapes`, n × any number: the modes of the range, all of them, as without one its pole is not seen coming.
  ReducedSweep(const SteadySolver& solver, ComplexVector force, const ComplexMatrix& shapes);

  /// q of H(ω)q = f, where H is regular. n
  ComplexVector at(double omega);
  /// Factorisations that were made.
  Index factored() const { return factored_; }

 private:
  void add(const ComplexVector& w);
  ComplexVector projected(double omega) const;

  const SteadySolver& solver_;
  ComplexVector force_;
  std::shared_ptr<const sparse::ShiftedFactor> near_;  // of the last frequency that was factored
  Index size_ = 0, modes_ = 0, factored_ = 0;          // columns of W, and those that are the modes
  ComplexMatrix basis_;                                // W, WᴴW = 1, the first size_ columns
  ComplexMatrix k_, m_, jg_;                           // WᴴKW, WᴴMW, WᴴjGW
  ComplexVector in_basis_;                             // Wᴴf
};

}  // namespace gyromode
