#include "gyromode/modes/spacecraft_spectrum.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/modes/seeds.h"
#include "gyromode/modes/spacecraft_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gyromode {

namespace {

// Where a root may be: its error bound, and not less than what rounding of ω itself leaves open.
double open_error(const Root& r) { return std::max(r.error, 4 * epsilon * r.omega); }

// The tilt is the root at Ω: H(Ω) takes (θ1, θ2) = (1, j) to zero. Of several so near it is the one that is most like
// it.
void name_tilt(std::vector<Root>& all) {
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

// Spin phase (axis 3 of θ), axial translation (axis 3 of ζ), and the neutral patterns of wires, in which the body
// rests: pairs of zero roots.
Mode zero_mode(std::size_t which, bool with_shape) {
  constexpr Index axial = 2, spin_phase = 5;
  Mode m;
  m.energy_sign = 0;
  m.kind = ModeKind::rigid_body;
  if (with_shape)
    m.shape = which == 0   ? ComplexVector(ComplexVector::Unit(6, axial))
              : which == 1 ? ComplexVector(ComplexVector::Unit(6, spin_phase))
                           : ComplexVector(ComplexVector::Zero(6));
  return m;
}

Mode mode_of(const SpacecraftSpectrum& s, const Root& r, bool with_shape) {
  const double unit = s.unit();
  Mode m;
  m.omega = r.omega * unit;
  m.energy_sign = r.energy_sign;
  m.residual = std::abs(r.value / (r.omega * r.slope));
  m.error_bound = r.rigid ? 0 : r.error * unit;
  m.bracket = std::array{std::min(r.lo, r.omega) * unit, std::max(r.hi, r.omega) * unit};
  m.kind = r.rigid ? ModeKind::rigid_body : body_at_rest(r) ? ModeKind::local : ModeKind::vibration;
  if (with_shape) add_shape(s, r, m);
  return m;
}

std::string doubt_of(const Root& r, double unit) {
  return std::isfinite(r.error) && r.omega > 0 ? "" : fmt::format("the root near ω = {:.6g} did not settle", r.omega * unit);
}

}  // namespace

SpacecraftSpectrum::SpacecraftSpectrum(const Spacecraft& s)
    : spacecraft_(s),
      impedance_(s),
      roots_(impedance_, SpacecraftImpedance::free_coordinates(), SpacecraftImpedance::cyclic_coordinates(), impedance_.neutral_patterns(),
             [&s](Index attempt) { return seeds_of(s, attempt); }),
      opposite_gap_(gap_of_opposite_signs()) {}

Index SpacecraftSpectrum::zero_roots() const {
  constexpr Index spin_and_axial = 2;
  return spin_and_axial + impedance_.neutral_patterns();
}

// Roots in a little more than the range, so that what stands on an end is seen; the tilt among them exactly at Ω.
RootRange SpacecraftSpectrum::roots(const Window& range, const Progress& progress) const {
  constexpr double margin = 1e-9;
  const double b = range.open() ? std::max(above_all(), 2 * range.a) : range.b;
  RootsBetween between = roots_.between(range.a * (1 - margin), b * (1 + margin), progress);
  name_tilt(between.roots);
  const auto found = std::make_shared<const std::vector<Root>>(std::move(between.roots));
  const std::size_t zeros = range.a == 0 ? static_cast<std::size_t>(zero_roots()) : 0;
  RootRange r;
  r.known_below = between.known_below;
  r.roots.assign(zeros, {0, 0, 0, true, true, ""});
  for (const Root& root : *found)
    r.roots.push_back({root.omega, open_error(root), root.energy_sign, false, root.rigid, doubt_of(root, unit())});
  r.mode = [this, found, zeros](std::size_t i, bool with_shape) {
    return i < zeros ? zero_mode(i, with_shape) : mode_of(*this, (*found)[i - zeros], with_shape);
  };
  return r;
}

std::string SpacecraftSpectrum::reach_reason() const {
  return fmt::format("fields of wires are followed up to {:.0e} times the spin, {:.6g} rad/s", farthest_over_spin,
                     farthest_over_spin * unit());
}

Index SpacecraftSpectrum::missed_by_signs(const Window& range) const {
  return 2 * std::count_if(roots_.negative_energy().begin(), roots_.negative_energy().end(),
                           [&](const Root& r) { return range.contains(r.omega); });
}

Index SpacecraftSpectrum::negative_at_zero() const {
  const auto& blocks = roots_.blocked().blocks;
  Index sum = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) sum += roots_.at_zero().count[b] * blocks[b].copies();
  return sum;
}

std::string SpacecraftSpectrum::open_reason() const {
  return roots_.at_zero().doubtful ? "the static stiffness is singular to rounding"
                                   : "the index balance does not close: modes of negative energy or growing ones are missing";
}

IndexBalance SpacecraftSpectrum::balance() const {
  IndexBalance b;
  b.negative = roots_.at_zero().negative;
  Index reduced = 0;
  for (std::size_t k = 0; k < roots_.at_zero().reduced.size(); ++k)
    reduced += roots_.at_zero().reduced[k] * roots_.blocked().blocks[k].copies();
  for (const UnstableRoot& g : roots_.growing()) (g.omega > 0 ? b.quadruples : b.real_pairs) += g.copies;
  b.negative_energy = static_cast<Index>(roots_.negative_energy().size());
  b.zero = zero_roots();
  b.zero_negative = b.negative - reduced;
  b.closed = roots_.closed();
  return b;
}

Stability SpacecraftSpectrum::stability() const {
  constexpr double rounding = 1e-13;  // opposite signs nearer than this may be turned into flutter by it
  if (!roots_.growing().empty()) return Stability::unstable;
  if (!roots_.closed()) return Stability::unknown;
  if (opposite_gap_ <= rounding) return Stability::marginal;
  return roots_.negative_energy().empty() ? Stability::stable : Stability::gyroscopically_stabilised;
}

double SpacecraftSpectrum::gap_of_opposite_signs() const {
  double gap = infinity;
  for (const Root& negative : roots_.negative_energy()) {
    constexpr double around = 0.5;
    for (const Root& r : roots_.between((1 - around) * negative.omega, (1 + around) * negative.omega).roots) {
      if (r.block == negative.block && r.energy_sign > 0) gap = std::min(gap, std::abs(r.omega / negative.omega - 1));
    }
  }
  return gap;
}

std::string SpacecraftSpectrum::solver() const {
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
                     !roots_.indefinite() ? ""
                     : roots_.asked_for_seeds()
                         ? " with signs; negative energy and growth from the signs and from a twin of finite elements, made exact"
                         : " with signs; negative energy and growth from the signs");
}

double SpacecraftSpectrum::above_all() const {
  const auto& blocked = roots_.blocked();
  constexpr double farthest = 1e150;
  for (double b = 2; b < farthest; b *= 4) {
    const Lifted lifted = blocked.impedance.at(b);
    Index count = 0;
    for (const Block& block : blocked.blocks) count += state_of(block, lifted).count * block.copies();
    if (count == blocked.impedance.size()) return b;
  }
  throw InvalidArgument("no frequency above every mode was found: some spring is stiffer than numbers allow; make it rigid (inf)");
}

void SpacecraftSpectrum::describe(ModesResult& r, bool with_shapes) const {
  const IndexBalance b = balance();
  r.transcendental = true;
  r.structure = structure_of(roots_.blocked());
  r.solver = solver();
  r.stability = stability();
  r.stiffness = {b.negative, b.zero};
  r.opposite_gap = opposite_gap_;
  if (with_shapes) r.outlines = outlines_of(*this);
  for (const Root& root : roots_.negative_energy()) r.negative_modes.push_back(mode_of(*this, root, false));
  for (const UnstableRoot& g : roots_.growing()) {
    for (Index k = 0; k < g.copies; ++k) r.unstable.push_back({g.growth * unit(), g.omega * unit(), g.residual, g.error * unit(), {}});
  }
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
