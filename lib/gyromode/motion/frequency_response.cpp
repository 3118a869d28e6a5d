#include "gyromode/motion/frequency_response.h"

#include "gyromode/lapack/indefinite.h"
#include "gyromode/modes/modes.h"
#include "gyromode/motion/zero_part.h"
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

// Xᴴf beyond what rounding, and the error of X towards a neighbour at the distance `gap`, leave of it; the units of the coordinates taken out by the scale of M.
bool drives(const Mode& m, double gap, const Vector& force, const Vector& scale) {
  const double work = std::abs(m.shape.dot(force.cast<Complex>()));
  const double size = m.shape.cwiseQuotient(scale.cast<Complex>()).norm() * force.cwiseProduct(scale).norm();
  constexpr double most = 1e-3;  // more says that the pair is defective, and either shape of it will do
  const double mixed = std::min(most, 10 * (m.error_bound + std::numeric_limits<double>::epsilon() * m.omega) / gap);
  return work > (1e3 * static_cast<double>(force.size()) * std::numeric_limits<double>::epsilon() + mixed) * size;
}

// Zero roots that the force drives, places and drifts: the response at rest is unbounded.
bool drives_zero_roots(const System& system, const Vector& force) {
  for (const SolvedComponent& c : solve_components(system, dense::Method::automatic).components) {
    if (c.spectrum.zero_pairs() == 0) continue;
    const ComponentMatrices m(system, c.spectrum.order);
    const ZeroPart zero(m, c.spectrum.zero_pairs());
    if (!zero.complete()) return true;
    const Vector own = force(c.spectrum.order);
    const Vector excited = zero.excitation(own), most = zero.largest_excitation(own);
    for (Index i = 0; i < excited.size(); ++i) {
      if (std::abs(excited(i)) > 1e-10 * most(i)) return true;
    }
  }
  return false;
}

std::vector<Resonance> resonances_in(const System& system, const Vector& force, const Vector& grid) {
  ModesOptions options;
  options.shapes = true;
  const Vector scale = unit_diagonal_scale(system.mass());
  const std::vector<Mode> modes = find_modes(system, options).modes;
  std::vector<Resonance> all;
  bool at_rest = false;
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const Mode& m = modes[k];
    if (m.omega == 0) {
      at_rest = true;
      continue;
    }
    constexpr double widest = 1e-7;  // near a defective pair bounds say nothing, and the response is finite but there
    const double error = std::min(m.error_bound + 4 * std::numeric_limits<double>::epsilon() * m.omega, widest * m.omega);
    if (m.omega + error < grid(0) || m.omega - error > grid(grid.size() - 1)) continue;
    double gap = m.omega;
    if (k > 0) gap = std::min(gap, m.omega - modes[k - 1].omega);
    if (k + 1 < modes.size()) gap = std::min(gap, modes[k + 1].omega - m.omega);
    all.push_back({m.omega, error, drives(m, std::max(gap, error), force, scale)});
  }
  if (at_rest && grid(0) == 0) all.push_back({0, 0, drives_zero_roots(system, force)});
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
  if (omega == 0) {  // q(−ω) is the conjugate of q(ω)
    const double typical = std::sqrt(system.stiffness().norm() / system.mass().norm()) + system.gyroscopic().norm() / system.mass().norm();
    return {0, solved(system, force, beside * (typical > 0 ? typical : 1)).real().cast<Complex>(), false, false};
  }
  return {omega, 0.5 * (solved(system, force, omega * (1 + beside)) + solved(system, force, omega * (1 - beside))), false, false};
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
