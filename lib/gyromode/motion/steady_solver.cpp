#include "gyromode/motion/steady_solver.h"

#include "gyromode/base/error.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/partition.h"

#include <cmath>

namespace gyromode {

SteadySolver::SteadySolver(const SparseSystem& system)
    : system_(system), groups_(sparse::groups_of(sparse::analyse(system), system.size())), impedance_(system, groups_) {}

ComplexVector SteadySolver::impedance_times(double omega, const ComplexVector& q) const {
  const Matrix parts = sparse::parts_of(q);
  const Matrix still = sparse::symmetric_times(system_.stiffness(), parts) - omega * omega * sparse::symmetric_times(system_.mass(), parts);
  const Matrix turned = omega * sparse::skew_times(system_.gyroscopic(), parts);  // jωG
  ComplexVector h(q.size());
  h.real() = still.col(0) - turned.col(1);
  h.imag() = still.col(1) + turned.col(0);
  return h;
}

ComplexVector SteadySolver::at(double omega, const ComplexVector& force) const {
  const auto factor = impedance_.at(omega);
  ComplexVector q = factor->solve(force);
  q += factor->solve(force - impedance_times(omega, q));
  return q;
}

ComplexVector SteadySolver::beside(double omega, const ComplexVector& force) const {
  constexpr double away = 1e-6;
  if (omega > 0) return 0.5 * (at(omega * (1 + away), force) + at(omega * (1 - away), force));
  const double typical = std::sqrt(sparse::norm1(system_.stiffness()) / sparse::norm1(system_.mass())) + system_.gyroscopic_size();
  return at(away * (typical > 0 ? typical : 1), force).real().cast<Complex>();
}

Vector SteadySolver::accelerations(const Vector& force) const {
  if (system_.singular_mass())
    throw NotApplicable("M is singular to rounding: what a sudden push does to motions without mass is not determined");
  std::vector<Index> all(static_cast<std::size_t>(system_.size()));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
  sparse::SymmetricFactor mass(system_.mass(), sparse::elimination_order(system_, all), sparse::SymmetricFactor::Keep::factors,
                               sparse::SymmetricFactor::Kind::definite);
  mass.factor(system_.mass());
  return mass.solve(force);
}

double SteadySolver::size_of(const Vector& f) const {
  return std::sqrt(system_.singular_mass() ? f.dot(f.cwiseQuotient(system_.mass().diagonal())) : f.dot(accelerations(f)));
}

}  // namespace gyromode
