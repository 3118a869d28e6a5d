#include "gyromode/motion/energy_norm.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace gyromode {

namespace {

// c of the norm: for K ≥ 0 with zero roots the square of the lowest frequency there is.
double shift(const ComponentMatrices& m, const SolvedComponent& c) {
  const dense::Spectrum& s = c.spectrum;
  if (s.stiffness_negative == 0) {
    if (s.stiffness_zero == 0) return 0;
    const double lowest = s.omega.size() > 0 ? s.omega(0) : c.impedance.typical_frequency();
    return lowest > 0 ? lowest * lowest : 1;
  }
  const Vector squares = Eigen::GeneralizedSelfAdjointEigenSolver<Matrix>(m.stiffness, m.mass, Eigen::EigenvaluesOnly).eigenvalues();
  return -2 * squares(0);
}

}  // namespace

EnergyNorm::EnergyNorm(const ComponentMatrices& m, const SolvedComponent& component) : mass_(m.mass), stiffness_(m.stiffness + shift(m, component) * m.mass) {
  if (stiffness_.info() == Eigen::Success) return;
  // K is positive by rounding only: its largest frequency serves all.
  const double typical = component.impedance.typical_frequency();
  stiffness_.compute((typical > 0 ? typical * typical : 1) * m.mass);
}

Vector EnergyNorm::coordinates(const State& w) const {
  Vector x(2 * w.q.size());
  x << stiffness_.matrixU() * w.q, mass_.matrixU() * w.qdot;
  return x;
}

State EnergyNorm::state(const Vector& x) const {
  const Index n = x.size() / 2;
  return {stiffness_.matrixU().solve(x.head(n)), mass_.matrixU().solve(x.tail(n))};
}

}  // namespace gyromode
