#pragma once

#include "gyromode/modes/components.h"
#include "gyromode/motion/state.h"

#include <vector>

namespace gyromode {

/// The matrices of one component, n × n, in the order of its Spectrum.
struct ComponentMatrices {
  Matrix mass, gyroscopic, stiffness;

  ComponentMatrices(const System& system, const std::vector<Index>& order);
};

/// The undamped simple modes of a component as a basis of motion: (q, q̇) = Σ 2 Re a_s (X_s, jω_s X_s) e^{jω_s t}
/// (Boland & Janssens 1979, Eq. 7). With 𝒮 = [G M; −M 0] two motions e^{λt} have w_kᴴ𝒮w_i = 0 unless λ_i = −λ̄_k, so
/// that
///     a_s = (ω_s X_sᴴMq − jX_sᴴ(Mq̇ + Gq)) / X_sᴴ(2ω_sM − jG)X_s
/// without a linear solve. A force f u(t) gives ȧ = jωa + h u(t) with h the amplitudes of the state (0, M⁻¹f). Modes
/// whose form vanishes to rounding (double roots of opposite energy) are left to the Remainder.
class ModalPart {
 public:
  ModalPart(const ComponentMatrices& matrices, const SolvedComponent& component);

  Index size() const { return omega_.size(); }
  const Vector& omega() const { return omega_; }
  const ComplexMatrix& shapes() const { return shapes_; }  ///< n × size
  const Vector& form() const { return form_; }             ///< Xᴴ(2ωM − jG)X
  const Vector& error() const { return error_; }           ///< of ω (frequency_errors)

  ComplexVector amplitudes(const ComponentMatrices& m, const State& w) const;
  State state(const ComplexVector& a) const;

 private:
  Vector omega_, form_, error_;
  ComplexMatrix shapes_;
};

}  // namespace gyromode
