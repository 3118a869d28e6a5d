// Steady response of sparse systems.
#include "gyromode/modes/modes.h"
#include "gyromode/motion/driven_runs.h"
#include "gyromode/motion/driven_sweep.h"
#include "gyromode/motion/frequency_response.h"
#include "gyromode/motion/reduced_sweep.h"
#include "gyromode/motion/steady_solver.h"
#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/blas_threads.h"
#include "gyromode/sparse/matrix.h"

#include "gyromode/base/rounding.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// |Xᴴf|² / XᴴMX; a mode whose every coordinate that is pushed has exactly 0 is not met.
PoleMet met_at(double omega, double error, const SparseSystem& s, const ComplexVector& shape, const Vector& force) {
  const Matrix p = sparse::from_given(s, sparse::parts_of(shape));
  const double mass = p.cwiseProduct(sparse::symmetric_times(s.mass(), p)).sum();
  return {omega, error, std::norm(shape.dot(force.cast<Complex>())) / mass, shape.cwiseAbs().dot(force.cwiseAbs()) > 0};
}

// Of every coordinate, whether a force acts on the component that it belongs to.
std::vector<bool> reached_by(const Vector& force, const Structure& structure) {
  std::vector<bool> reached(static_cast<std::size_t>(force.size()), false);
  for (const Component& c : structure.components) {
    const bool any = std::any_of(c.coordinates.begin(), c.coordinates.end(), [&](Index i) { return force(i) != 0; });
    for (const Index i : c.coordinates) reached[static_cast<std::size_t>(i)] = any;
  }
  return reached;
}

double error_of(const Mode& m) { return m.error_bound + 4 * epsilon * m.omega; }

// A mode whose errors leave it apart from its neighbours has its shape in one component, whatever rounding puts
// elsewhere.
bool stands_alone(const std::vector<Mode>& all, std::size_t k) {
  const auto apart = [&](const Mode& a, const Mode& b) { return b.omega - a.omega > error_of(a) + error_of(b); };
  return (k == 0 || apart(all[k - 1], all[k])) && (k + 1 == all.size() || apart(all[k], all[k + 1]));
}

// Modes in and about the range, ascending: those a little beyond tell how well shapes near its ends are known.
ModesResult modes_about(const SparseSystem& s, const Vector& grid, const Progress& progress) {
  constexpr double beyond = 0.1;
  const double first = grid(0), last = grid(grid.size() - 1);
  ModesOptions options;
  options.shapes = true;
  options.progress = progress;
  options.window = {(1 - beyond) * first, (1 + beyond) * last};
  if (last == 0) {
    options.window = {};
    options.lowest = 1;
  }
  return find_modes(s, options);
}

std::vector<DrivenMode> poles_of(const SparseSystem& s, const ModesResult& found, const Vector& force, double whole) {
  std::vector<PoleMet> poles;
  for (Index k = 0; k < s.translations().cols(); ++k) {  // a double root at the spin, which is no mode
    const Vector t = s.translations().col(k);
    const double stiff = t.dot(sparse::symmetric_times(s.stiffness(), Matrix(t)).col(0));
    const double omega = std::sqrt(std::abs(stiff / t.dot(sparse::symmetric_times(s.mass(), Matrix(t)).col(0))));
    poles.push_back(met_at(omega, 1e-7 * omega, s, sparse::in_given(s, t.cast<Complex>()), force));
  }
  std::vector<DrivenMode> rest;
  const std::vector<bool> reached = reached_by(force, found.structure);
  for (std::size_t k = 0; k < found.modes.size(); ++k) {
    const Mode& m = found.modes[k];
    PoleMet p = met_at(m.omega, error_of(m), s, m.shape, force);
    Index largest = 0;
    m.shape.cwiseAbs().maxCoeff(&largest);
    p.met = p.met && (reached[static_cast<std::size_t>(largest)] || !stands_alone(found.modes, k));
    if (m.omega > 0) {
      poles.push_back(p);
      continue;
    }
    constexpr double resolution = 1e-10;
    const double participation = whole > 0 ? std::sqrt(p.work2) / whole : 0;
    const DrivenMode zero{0, 0, participation, resolution, judged(p.met, participation, resolution)};
    if (rest.empty() || zero.participation > rest.front().participation) rest.assign(1, zero);
  }
  std::stable_sort(poles.begin(), poles.end(), [](const PoleMet& a, const PoleMet& b) { return a.at < b.at; });
  const std::vector<DrivenMode> all = judged(poles, {whole, whole, s.size()});
  rest.insert(rest.end(), all.begin(), all.end());
  return rest;
}

// Shapes of all that has a pole in or about the range, in the coordinates that the system is written in.
ComplexMatrix shapes_of(const SparseSystem& s, const ModesResult& found) {
  ComplexMatrix all(s.size(), static_cast<Index>(found.modes.size()) + s.translations().cols());
  Index k = 0;
  for (const Mode& m : found.modes) {
    const Matrix p = sparse::from_given(s, sparse::parts_of(m.shape));
    all.col(k).real() = p.col(0);
    all.col(k++).imag() = p.col(1);
  }
  for (Index t = 0; t < s.translations().cols(); ++t) all.col(k++) = s.translations().col(t).cast<Complex>();
  return all;
}

}  // namespace

FrequencyResponse frequency_response(const SparseSystem& system, const Vector& force, const Vector& grid, const std::vector<Index>& chosen,
                                     bool resolve, const Progress& progress) {
  require_sweep(force, grid, system.size());
  if (grid.size() == 0) return {};
  const ModesResult found = modes_about(system, grid, progress);
  const auto threads = sparse::few_blas_threads(system.size());
  const SteadySolver solver(system);
  const ComplexVector f = sparse::from_given(system, force).col(0).cast<Complex>();
  const auto seen = [&](const ComplexVector& p) {
    const ComplexVector q = sparse::in_given(system, p);
    return chosen.empty() ? q : ComplexVector(q(chosen));
  };
  DrivenSweep sweep;
  ReducedSweep reduced(solver, f, shapes_of(system, found));
  const bool all_known = found.coverage.status == CoverageStatus::complete;
  sweep.solved = [&](double omega) { return seen(all_known ? reduced.at(omega) : solver.at(omega, f)); };
  sweep.limit = [&](double omega) { return seen(solver.beside(omega, f)); };
  sweep.poles = within(grid, poles_of(system, found, force, solver.size_of(f.real())));
  sweep.progress_of = "frequencies";
  FrequencyResponse r = sweep.over(grid, resolve, progress);
  r.coverage = found.coverage;
  return r;
}

}  // namespace gyromode
