#include "gyromode/motion/steady_solver.h"

#include "gyromode/base/error.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/partition.h"

#include <cmath>

namespace gyromode {

SteadySolver::SteadySolver(const SparseSystem& system)
    : system_(system), groups_(sparse::groups_of(sparse::analyse(system), system.size())), impedance_(system, groups_) {}

SteadySolver::Products SteadySolver::products(const ComplexVector& q) const {
  const Matrix parts = sparse::parts_of(q);
  const Matrix k = sparse::symmetric_times(system_.stiffness(), parts), m = sparse::symmetric_times(system_.mass(), parts);
  const Matrix g = sparse::skew_times(system_.gyroscopic(), parts);
  const Complex j(0, 1);
  return {k.col(0) + j * k.col(1), m.col(0) + j * m.col(1), j * g.col(0) - g.col(1)};
}

ComplexVector SteadySolver::at(double omega, const ComplexVector& force) const {
  const auto factor = impedance_.at(omega);
  ComplexVector q = factor->solve(force);
  q += factor->solve(force - products(q).at(omega));
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
