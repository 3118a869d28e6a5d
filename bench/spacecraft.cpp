#include "rows.h"

#include "machine.h"

#include "gyromode/dense/solve.h"
#include "gyromode/elements/spin_phase.h"
#include "gyromode/elements/discretise.h"
#include "gyromode/modes/discrete.h"
#include "gyromode/modes/spacecraft.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace gyromode::bench {

namespace {

Spacecraft geos() {
  const double height = -0.2511013215859031;
  return Spacecraft(std::numbers::pi / 3, {272.4, Eigen::Vector3d(85, 100, 120).asDiagonal()},
                    {{0.5 * std::numbers::pi, 0.825, height, 20, 0.03, 0}, {1.5 * std::numbers::pi, 0.825, height, 20, 0.03, 0}});
}

std::vector<double> vibrations(const ModesResult& r) {
  std::vector<double> omega;
  for (const Mode& m : r.modes) {
    if (m.kind != ModeKind::rigid_body) omega.push_back(m.omega);
  }
  return omega;
}

// Worst relative difference of the first `count` frequencies.
double worst(const std::vector<double>& fine, const std::vector<double>& exact, std::size_t count) {
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) largest = std::max(largest, std::abs(fine[i] / exact[i] - 1));
  return largest;
}

}  // namespace

std::vector<Row> spacecraft_rows(const RowOptions& options) {
  const Spacecraft s = geos();
  const double spins = 40;
  ModesOptions below;
  below.window.b = spins * s.spin();
  const ModesResult reference = find_modes(s, below);
  const std::vector<double> exact = vibrations(reference);
  std::vector<Row> rows;
  for (const double elements : {160.0, 320.0, 640.0}) {
    const Mesh mesh{std::max<Index>(40, static_cast<Index>(elements * options.n_scale)), 1};
    const std::vector<double> fine = vibrations(find_modes(s, mesh, below));
    const double lowest = worst(fine, exact, 6);
    const WithoutSpinPhase twin(discretise(s, mesh), spin_phase_of_twin);
    const Structure structure = analyse(twin.system());
    const Contestant ours{"find_modes", "exact fields, all modes below 40 spins, certified", {}, [&] { find_modes(s, below); }};
    const Contestant theirs{
        "finite elements", fmt::format("dense::solve of M, G, K, {} linear elements a wire, given", mesh.elements), {}, [&] {
          for (const Component& c : structure.components) dense::solve(twin.system(), c);
        }};
    const Others others;
    Row row{"f",
            fmt::format("Geos, {} modes; {} elements a wire (n = {}) miss the six lowest by {:.1e}, the highest by {:.1e}; 1e-9 of the six "
                        "needs about {:.0f}",
                        exact.size(), mesh.elements, twin.system().size(), lowest,
                        fine.size() >= exact.size() ? worst(fine, exact, exact.size()) : 1.0,
                        static_cast<double>(mesh.elements) * std::sqrt(lowest / 1e-9)),
            reference.solver, 0, interleaved({ours, theirs}, mesh.elements > 400 ? std::min(options.rounds, 3) : options.rounds)};
    row.others = others.share();
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace gyromode::bench
