#include "gyromode/modes/spacecraft_solution.h"

#include "gyromode/discrete/spin_phase.h"
#include "gyromode/discrete/discretise.h"
#include "gyromode/lapack/status.h"
#include "gyromode/modes/modes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace gyromode {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Modes of opposite energy that the twin has near each other may be fluttering, and the reverse: both ways are looked.
void add_pairs(const ModesResult& twin, double unit, Seeds& seeds) {
  constexpr double near = 0.05;
  for (const Mode& negative : twin.negative_modes) {
    for (const Mode& m : twin.modes) {
      const double gap = std::abs(m.omega - negative.omega);
      if (m.energy_sign > 0 && gap > 0 && gap <= near * negative.omega) seeds.growing.push_back(Complex(0.5 * gap, 0.5 * (m.omega + negative.omega)) / unit);
    }
  }
  for (const UnstableMode& u : twin.unstable) {
    if (u.flutter() && u.growth_rate <= near * u.omega) seeds.negative_energy.push_back(u.omega / unit);
  }
}

// What a twin of finite elements knows of negative energy and growth: first a small one of some milliseconds, then one of some 400 coordinates at most, for this is a dense eigenproblem.
std::optional<Seeds> seeds_of(const Spacecraft& s, Index attempt) {
  const Index booms = std::max<Index>(1, static_cast<Index>(s.cables().size() + s.beams().size()));
  const Index degrees[] = {4, std::clamp<Index>(200 / booms, 5, 16)};
  if (attempt >= static_cast<Index>(std::size(degrees))) return std::nullopt;
  constexpr double highest = 30;  // spins: growth and negative energy are slow motions
  Seeds seeds;
  try {
    const WithoutSpinPhase whole(discretise(s, {1, degrees[attempt]}), spin_phase_of_twin);
    const ModesResult twin = find_modes(low_modes(whole.system(), highest * s.spin()));
    for (const Mode& m : twin.negative_modes) seeds.negative_energy.push_back(m.omega / s.spin());
    for (const UnstableMode& u : twin.unstable) seeds.growing.push_back(Complex(u.growth_rate, u.omega) / s.spin());
    add_pairs(twin, s.spin(), seeds);
  } catch (const lapack::Failure&) {  // then there are none, and the balance says that something is missing
  }
  return seeds;
}

}  // namespace

double open_error(const Root& r) { return std::max(r.error, 4 * std::numeric_limits<double>::epsilon() * r.omega); }

SpacecraftSolution::SpacecraftSolution(const Spacecraft& s)
    : spacecraft_(s), impedance_(s),
      roots_(impedance_, SpacecraftImpedance::free_coordinates(), SpacecraftImpedance::cyclic_coordinates(), impedance_.neutral_patterns(), [&s](Index attempt) { return seeds_of(s, attempt); }),
      opposite_gap_(gap_of_opposite_signs()) {}

Index SpacecraftSolution::zeros() const {
  constexpr Index spin_and_axial = 2;
  return spin_and_axial + impedance_.neutral_patterns();
}

IndexBalance SpacecraftSolution::balance() const {
  IndexBalance b;
  b.negative = roots_.at_zero().negative;
  Index reduced = 0;
  for (std::size_t k = 0; k < roots_.at_zero().reduced.size(); ++k) reduced += roots_.at_zero().reduced[k] * roots_.blocked().blocks[k].copies();
  for (const GrowingRoot& g : roots_.growing()) (g.omega > 0 ? b.quadruples : b.real_pairs) += g.copies;
  b.negative_energy = static_cast<Index>(roots_.negative_energy().size());
  b.zero = zeros();
  b.zero_negative = b.negative - reduced;
  b.closed = roots_.closed();
  return b;
}

Stability SpacecraftSolution::stability() const {
  constexpr double rounding = 1e-13;  // opposite signs nearer than this may be turned into flutter by it
  if (!roots_.growing().empty()) return Stability::unstable;
  if (!roots_.closed()) return Stability::unknown;
  if (opposite_gap_ <= rounding) return Stability::marginal;
  return roots_.negative_energy().empty() ? Stability::stable : Stability::gyroscopically_stabilised;
}

double SpacecraftSolution::gap_of_opposite_signs() const {
  double gap = infinity;
  for (const Root& negative : roots_.negative_energy()) {
    constexpr double around = 0.5;
    for (const Root& r : roots_.between((1 - around) * negative.omega, (1 + around) * negative.omega)) {
      if (r.block == negative.block && r.energy_sign > 0) gap = std::min(gap, std::abs(r.omega / negative.omega - 1));
    }
  }
  return gap;
}

std::string SpacecraftSolution::path() const {
  Index real = 0, local = 0;
  const auto& blocks = roots_.blocked().blocks;
  for (const Block& b : blocks) {
    real += b.real ? 1 : 0;
    local += b.coordinates.front() >= body_coordinates ? b.copies() : 0;
  }
  const Index all = static_cast<Index>(blocks.size());
  return fmt::format("exact fields, poles lifted: {} {} apart ({}{}), roots bisected on the count{}", all, all == 1 ? "block" : "blocks",
                     real == all ? "all real symmetric" : fmt::format("{} real symmetric, {} Hermitian", real, all - real),
                     local > 0 ? fmt::format(", {} boom patterns without the body", local) : "",
                     !roots_.indefinite() ? "" : roots_.asked_for_seeds() ? " with signs; negative energy and growth from the signs and from a twin of finite elements, made exact" : " with signs; negative energy and growth from the signs");
}

double SpacecraftSolution::above_all() const {
  const auto& blocked = roots_.blocked();
  constexpr double farthest = 1e150;
  for (double b = 2; b < farthest; b *= 4) {
    const Lifted lifted = blocked.impedance.at(b);
    Index count = 0;
    for (const Block& block : blocked.blocks) count += state_of(block, lifted).count * block.copies();
    if (count == blocked.impedance.size()) return b;
  }
  throw std::invalid_argument("no frequency above every mode was found: some spring is stiffer than numbers allow; make it rigid (inf)");
}

Window SpacecraftSolution::cleared(Window w) const {
  constexpr double first_step = 1e-14;
  const auto moved = [&](double end, double way) {
    double step = first_step;
    double at = end;
    while (roots_.doubtful_at(at) && step < 1e-3) {
      at = end * (1 + way * step);
      step *= 2;
    }
    return at;
  };
  if (w.a > 0) w.a = moved(w.a, -1);
  w.b = moved(w.b, 1);
  return w;
}

std::vector<Root> SpacecraftSolution::roots_around(double a, double b) const {
  constexpr double margin = 1e-9;
  std::vector<Root> all = roots_.between(a * (1 - margin), b * (1 + margin));
  name_tilt(all);
  return all;
}

// The tilt is the root at Ω: H(Ω) takes (θ1, θ2) = (1, j) to zero. Of several so near it is the one that is most like it.
void SpacecraftSolution::name_tilt(std::vector<Root>& all) const {
  Root* tilt = nullptr;
  double best = 0;
  for (Root& r : all) {
    if (!(std::abs(r.omega - 1) <= 8 * r.error + 1e-12)) continue;
    const double likeness = std::abs(r.vector(3) - Complex(0, 1) * r.vector(4)) / std::sqrt(2);
    if (!tilt || likeness > best) {
      tilt = &r;
      best = likeness;
    }
  }
  if (!tilt) return;
  tilt->rigid = true;
  tilt->omega = 1;
  tilt->value = 0;
  tilt->vector.setZero();
  tilt->vector(3) = 1;
  tilt->vector(4) = Complex(0, 1);
  std::stable_sort(all.begin(), all.end(), [](const Root& x, const Root& y) { return x.omega < y.omega; });
}

Structure structure_of(const BlockedImpedance& h) {
  Structure s;
  for (const Block& b : h.blocks) {
    Component c;
    for (std::size_t k = 0; k < b.coordinates.size(); ++k) {
      if (b.coordinates[k] >= body_coordinates) continue;
      c.coordinates.push_back(b.coordinates[k]);
      if (b.real) (b.in_quadrature[k] == b.in_quadrature[0] ? c.in_phase : c.in_quadrature).push_back(b.coordinates[k]);
    }
    if (c.coordinates.empty()) continue;
    if (!b.real) c.odd_cycle = OddCycle{c.coordinates, {}};
    s.components.push_back(std::move(c));
  }
  return s;
}

}  // namespace gyromode
