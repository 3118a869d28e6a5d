#include "gyromode/motion/energy_norm.h"

#include "gyromode/lapack/symmetric.h"

#include <algorithm>

namespace gyromode {

namespace {

// c of the norm: for K ≥ 0 with zero roots the square of the lowest frequency there is.
double shift(const ComponentMatrices& m, const SolvedComponent& c) {
  const Spectrum& s = c.spectrum;
  if (s.stiffness_negative == 0) {
    if (s.stiffness_zero == 0) return 0;
    const double lowest = s.omega.size() > 0 ? s.omega(0) : c.impedance.typical_frequency();
    return lowest > 0 ? lowest * lowest : 1;
  }
  const Vector squares = lapack::symmetric_definite_eigen(m.stiffness, m.mass).values;
  return -2 * squares(0);
}

}  // namespace

EnergyNorm::EnergyNorm(const ComponentMatrices& m, const SolvedComponent& component)
    : mass_(m.mass), stiffness_(m.stiffness + shift(m, component) * m.mass) {
  if (stiffness_.positive()) return;
  // K is positive by rounding only: its largest frequency serves all.
  const double typical = component.impedance.typical_frequency();
  stiffness_ = lapack::Cholesky((typical > 0 ? typical * typical : 1) * m.mass);
}

Vector EnergyNorm::coordinates(const State& w) const {
  Vector x(2 * w.q.size());
  x << stiffness_.lower().transpose() * w.q, mass_.lower().transpose() * w.qdot;
  return x;
}

State EnergyNorm::state(const Vector& x) const {
  const Index n = x.size() / 2;
  State w{x.head(n), x.tail(n)};
  lapack::solve_lower_transposed(stiffness_.lower(), w.q);
  lapack::solve_lower_transposed(mass_.lower(), w.qdot);
  return w;
}

}  // namespace gyromode
