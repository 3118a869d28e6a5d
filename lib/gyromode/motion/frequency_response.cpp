#include "gyromode/motion/frequency_response.h"

#include "gyromode/base/error.h"
#include "gyromode/lapack/indefinite.h"
#include "gyromode/system/scale.h"
#include "gyromode/motion/driven_modes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

void require(const Vector& force, const Vector& grid, Index n) {
  if (force.size() != n) throw InvalidArgument(fmt::format("force: {} numbers where the system has {} coordinates", force.size(), n));
  if (!force.allFinite() || !grid.allFinite()) throw InvalidArgument("force and grid must be finite");
  for (Index k = 0; k < grid.size(); ++k) {
    if (!(grid(k) >= 0)) throw InvalidArgument(fmt::format("grid: a frequency of {:g} where ω ≥ 0 was expected", grid(k)));
    if (k > 0 && !(grid(k) > grid(k - 1)))
      throw InvalidArgument(fmt::format("grid: {:.17g} after {:.17g} where ascending frequencies were expected", grid(k), grid(k - 1)));
  }
}

std::vector<DrivenMode> modes_in(const System& system, const Vector& force, const Vector& grid) {
  const UnitMasses units = with_unit_masses(system);
  std::vector<DrivenMode> all = driven_modes(solve_components(units.system, Method::automatic), units, units.scale.cwiseProduct(force));
  std::erase_if(all, [&](const DrivenMode& m) { return m.omega + m.error < grid(0) || m.omega - m.error > grid(grid.size() - 1); });
  return all;
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

FrequencyPoint point(const System& system, const Vector& force, double omega, const std::vector<DrivenMode>& modes) {
  const DrivenMode* on = nullptr;  // the mode at ω that the force drives most plainly
  for (const DrivenMode& m : modes) {
    if (std::abs(omega - m.omega) <= m.error && (!on || m.driven > on->driven)) on = &m;
  }
  if (!on) return {omega, solved(system, force, omega), Driven::no, false, std::nullopt};
  if (on->driven == Driven::yes) return {omega, ComplexVector(0), Driven::yes, false, on->participation};
  return {omega, limit(system, force, omega), on->driven, false, on->participation};
}

// Points at ω_s(1 ± 10⁻²) … ω_s(1 ± 10⁻⁵), those within the grid.
void show(const DrivenMode& m, const System& system, const Vector& force, const Vector& grid, FrequencyResponse& r) {
  for (const double away : {1e-2, 1e-3, 1e-4, 1e-5}) {
    for (const double omega : {m.omega * (1 - away), m.omega * (1 + away)}) {
      if (omega < grid(0) || omega > grid(grid.size() - 1)) continue;
      r.points.push_back(point(system, force, omega, r.modes));
      r.points.back().added = true;
      r.points.back().participation = m.participation;
    }
  }
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
  require(force, grid, system.size());
  FrequencyResponse r;
  if (grid.size() == 0) return r;
  r.modes = modes_in(system, force, grid);
  for (const double omega : grid) {
    r.interrupted = r.interrupted || progress.stopped();
    if (r.interrupted) break;
    r.points.push_back(point(system, force, omega, r.modes));
    progress.report("frequencies", static_cast<Index>(r.points.size()), grid.size());
  }
  if (r.interrupted && r.points.empty()) throw Interrupted();
  if (r.interrupted) return r;
  for (const DrivenMode& m : r.modes) {
    if (resolve && m.driven == Driven::yes && m.omega > 0) show(m, system, force, grid, r);
  }
  std::stable_sort(r.points.begin(), r.points.end(), [](const FrequencyPoint& a, const FrequencyPoint& b) { return a.omega < b.omega; });
  return r;
}

}  // namespace gyromode
