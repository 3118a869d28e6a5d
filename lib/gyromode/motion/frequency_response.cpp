#include "gyromode/motion/frequency_response.h"

#include "gyromode/lapack/indefinite.h"
#include "gyromode/modes/modes.h"
#include "gyromode/system/scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace gyromode {

namespace {

struct Resonance {
  double omega, error;
  bool driven;
};

void require(const Vector& force, const Vector& grid, Index n) {
  if (force.size() != n) throw std::invalid_argument(fmt::format("force: {} numbers where the system has {} coordinates", force.size(), n));
  if (!force.allFinite() || !grid.allFinite()) throw std::invalid_argument("force and grid must be finite");
  for (Index k = 0; k < grid.size(); ++k) {
    if (!(grid(k) >= 0)) throw std::invalid_argument(fmt::format("grid: a frequency of {:g} where ω ≥ 0 was expected", grid(k)));
    if (k > 0 && !(grid(k) > grid(k - 1))) throw std::invalid_argument(fmt::format("grid: {:.17g} after {:.17g} where ascending frequencies were expected", grid(k), grid(k - 1)));
  }
}

// Xᴴf beyond rounding, the units of the coordinates taken out by the scale of M.
bool drives(const ComplexVector& shape, const Vector& force, const Vector& scale) {
  const double work = std::abs(shape.dot(force.cast<Complex>()));
  const double size = shape.cwiseQuotient(scale.cast<Complex>()).norm() * force.cwiseProduct(scale).norm();
  return work > 1e3 * static_cast<double>(force.size()) * std::numeric_limits<double>::epsilon() * size;
}

std::vector<Resonance> resonances_in(const System& system, const Vector& force, const Vector& grid) {
  ModesOptions options;
  options.shapes = true;
  const Vector scale = unit_diagonal_scale(system.mass());
  std::vector<Resonance> all;
  for (const Mode& m : find_modes(system, options).modes) {
    const double error = m.error_bound + 4 * std::numeric_limits<double>::epsilon() * m.omega;
    if (m.omega + error < grid(0) || m.omega - error > grid(grid.size() - 1)) continue;
    all.push_back({m.omega, error, drives(m.shape, force, scale)});
  }
  return all;
}

ComplexVector solved(const System& system, const Vector& force, double omega) {
  const ComplexMatrix h = system.impedance(omega);
  const Vector d = equilibrating_scale(h);
  const ComplexMatrix right = d.cwiseProduct(force).cast<Complex>();
  return d.asDiagonal() * lapack::solve(lapack::factor_indefinite(scaled(h, d)), right).col(0);
}

FrequencyPoint point(const System& system, const Vector& force, double omega, const std::vector<Resonance>& resonances) {
  bool near = false;
  for (const Resonance& r : resonances) {
    if (std::abs(omega - r.omega) > r.error) continue;
    if (r.driven) return {omega, ComplexVector(0), true, false};
    near = true;
  }
  if (!near) return {omega, solved(system, force, omega), false, false};
  constexpr double beside = 1e-6;
  const double step = beside * (omega > 0 ? omega : 1);
  return {omega, 0.5 * (solved(system, force, omega + step) + solved(system, force, std::abs(omega - step))), false, false};
}

}  // namespace

FrequencyResponse frequency_response(const System& system, const Vector& force, const Vector& grid, bool resolve) {
  require(force, grid, system.size());
  FrequencyResponse r;
  if (grid.size() == 0) return r;
  const std::vector<Resonance> resonances = resonances_in(system, force, grid);
  for (const double omega : grid) r.points.push_back(point(system, force, omega, resonances));
  for (const Resonance& s : resonances) {
    if (!s.driven) continue;
    r.resonances.push_back(s.omega);
    if (!resolve || s.omega == 0) continue;
    for (const double away : {1e-2, 1e-3, 1e-4, 1e-5}) {
      for (const double omega : {s.omega * (1 - away), s.omega * (1 + away)}) {
        if (omega < grid(0) || omega > grid(grid.size() - 1)) continue;
        r.points.push_back(point(system, force, omega, resonances));
        r.points.back().added = true;
      }
    }
  }
  std::stable_sort(r.points.begin(), r.points.end(), [](const FrequencyPoint& a, const FrequencyPoint& b) { return a.omega < b.omega; });
  return r;
}

}  // namespace gyromode
