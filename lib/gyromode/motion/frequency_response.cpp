#include "gyromode/motion/frequency_response.h"

#include "gyromode/lapack/indefinite.h"
#include "gyromode/system/scale.h"
#include "gyromode/motion/driven_modes.h"
#include "gyromode/motion/driven_sweep.h"

#include <cmath>

namespace gyromode {

namespace {

std::vector<DrivenMode> modes_in(const System& system, const Vector& force, const Vector& grid) {
  const UnitMasses units = with_unit_masses(system);
  return within(grid, driven_modes(solve_components(units.system, Method::automatic), units, units.scale.cwiseProduct(force)));
}

ComplexVector solved(const System& system, const Vector& force, double omega) {
  const ComplexMatrix h = system.impedance(omega);
  const Vector d = equilibrating_scale(h);
  const ComplexMatrix right = d.cwiseProduct(force).cast<Complex>();
  return d.asDiagonal() * lapack::solve(lapack::factor_indefinite(scaled(h, d)), right).col(0);
}

// The limit from both sides of a mode that is not driven.
ComplexVector limit(const System& system, const Vector& force, double omega) {
  constexpr double beside = 1e-6;
  if (omega > 0) return 0.5 * (solved(system, force, omega * (1 + beside)) + solved(system, force, omega * (1 - beside)));
  // q(−ω) is the conjugate of q(ω)
  const double typical = std::sqrt(system.stiffness().norm() / system.mass().norm()) + system.gyroscopic().norm() / system.mass().norm();
  return solved(system, force, beside * (typical > 0 ? typical : 1)).real().cast<Complex>();
}

}  // namespace

std::vector<double> FrequencyResponse::resonances() const {
  std::vector<double> all;
  for (const DrivenMode& m : modes) {
    if (m.driven == Driven::yes) all.push_back(m.omega);
  }
  return all;
}

FrequencyResponse frequency_response(const System& system, const Vector& force, const Vector& grid, bool resolve,
                                     const Progress& progress) {
  require_sweep(force, grid, system.size());
  if (grid.size() == 0) return {};
  DrivenSweep sweep;
  sweep.solved = [&](double omega) { return solved(system, force, omega); };
  sweep.limit = [&](double omega) { return limit(system, force, omega); };
  sweep.poles = modes_in(system, force, grid);
  sweep.progress_of = "frequencies";
  return sweep.over(grid, resolve, progress);
}

}  // namespace gyromode
