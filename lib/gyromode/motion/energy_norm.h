#pragma once

#include "gyromode/lapack/triangular.h"
#include "gyromode/motion/modal_part.h"

namespace gyromode {

/// How large a motion is: |w|² = q̇ᵀMq̇ + qᵀ(K + cM)q, twice the energy where K > 0, c = 0. Else c is twice what makes K
/// + cM positive, so that slow motion counts as fast one does: by its velocities. With LLᵀ = M and RᵀR = K + cM it is
/// the length of x = (Rq, Lᵀq̇), in which the matrix of the motion is skew for K > 0 (theory (T8)).
class EnergyNorm {
 public:
  EnergyNorm(const ComponentMatrices& m, const SolvedComponent& component);

  /// No square of it underflows or overflows where it does not.
  double operator()(const State& w) const {
    const Vector x = coordinates(w);
    const double largest = x.size() > 0 ? x.cwiseAbs().maxCoeff() : 0;
    return largest > 0 ? largest * (x / largest).norm() : largest;
  }
  Vector coordinates(const State& w) const;
  State state(const Vector& x) const;
  /// M⁻¹f.
  Matrix accelerations(const Matrix& forces) const { return mass_.solve(forces); }

 private:
  lapack::Cholesky mass_, stiffness_;
};

}  // namespace gyromode
