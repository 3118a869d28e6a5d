#include "gyromode/modes/spacecraft.h"

#include "gyromode/discrete/spin_phase.h"
#include "gyromode/impedance/certified_roots.h"
#include "gyromode/lapack/status.h"
#include "gyromode/modes/shape.h"
#include "gyromode/spacecraft/spacecraft_impedance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace gyromode {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Index spin_and_axial = 2;  // zero modes of any spacecraft
constexpr Index spin_phase = 2;      // θ3 among the coordinates of the twin

// Where the static stiffness is indefinite, the twin of finite elements knows where negative energy and growth may be.
Seeds seeds_of(const Spacecraft& s) {
  constexpr Mesh mesh{2, 8};
  constexpr double highest = 30;  // spins: growth and negative energy are slow motions
  Seeds seeds;
  try {
    const WithoutSpinPhase whole(discretise(s, mesh), spin_phase);
    const ModesResult twin = find_modes(low_modes(whole.system(), highest * s.spin()));
    for (const Mode& m : twin.negative_modes) seeds.negative_energy.push_back(m.omega / s.spin());
    for (const UnstableMode& u : twin.unstable) seeds.growing.push_back(Complex(u.growth_rate, u.omega) / s.spin());
  } catch (const lapack::Failure&) {  // then there are none, and the balance says that something is missing
  }
  return seeds;
}

Complex largest_displacement(const std::vector<ComplexMatrix>& field) {
  Complex largest = 0;
  for (const ComplexMatrix& line : field) {
    for (const Complex& z : line.reshaped()) {
      if (std::abs(z) > std::abs(largest)) largest = z;
    }
  }
  return largest == 0.0 ? 1 : largest;
}

// θ × p (Eigen's cross() conjugates complex vectors).
Eigen::Vector3cd rotated(const Eigen::Vector3cd& theta, const Eigen::Vector3d& p) {
  return {theta(1) * p(2) - theta(2) * p(1), theta(2) * p(0) - theta(0) * p(2), theta(0) * p(1) - theta(1) * p(0)};
}

// A spacecraft solved as far as windows can be cut from it.
class Solution {
 public:
  explicit Solution(const Spacecraft& s)
      : spacecraft_(s), impedance_(s), neutral_(impedance_.neutral_patterns()),
        roots_(impedance_, SpacecraftImpedance::free_coordinates(), SpacecraftImpedance::cyclic_coordinates(), neutral_, [&s] { return seeds_of(s); }) {}

  const CertifiedRoots& roots() const { return roots_; }
  const SpacecraftImpedance& impedance() const { return impedance_; }
  const Spacecraft& spacecraft() const { return spacecraft_; }
  double unit() const { return impedance_.unit_frequency(); }
  Index zeros() const { return spin_and_axial + neutral_; }

  IndexBalance balance() const {
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

  Stability stability() const {
    if (!roots_.growing().empty()) return Stability::unstable;
    if (roots_.at_zero().doubtful) return Stability::marginal;
    if (!roots_.closed()) return Stability::unknown;
    return roots_.negative_energy().empty() ? Stability::stable : Stability::gyroscopically_stabilised;
  }

  // The tilt of the momentum axis is the root at Ω: H(Ω) takes (θ1, θ2) = (1, j) to zero. Of several so near it is the one that is most like it.
  void name_tilt(std::vector<Root>& all) const {
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
    tilt->omega = 1;
    tilt->value = 0;
    tilt->error = 0;
    tilt->vector.setZero();
    tilt->vector(3) = 1;
    tilt->vector(4) = Complex(0, 1);
  }

  // A pattern without the body has exactly 0 there; where it shares a block with it (wires on the axis), rounding.
  bool body_at_rest(const Root& r) const {
    return r.vector.head<body_coordinates>().norm() <= 64 * std::numeric_limits<double>::epsilon() * r.vector.norm();
  }

  bool is_tilt(const Root& r) const { return r.omega == 1 && r.error == 0; }

  Mode mode(const Root& r, bool with_shape) const {
    Mode m;
    m.omega = r.omega * unit();
    m.energy_sign = r.energy_sign;
    m.residual = std::abs(r.value / (r.omega * r.slope));
    m.error_bound = r.error * unit();
    m.bracket = std::array{std::min(r.lo, r.omega) * unit(), std::max(r.hi, r.omega) * unit()};
    if (is_tilt(r)) m.omega = unit();
    m.kind = is_tilt(r) ? ModeKind::rigid_body : body_at_rest(r) ? ModeKind::local : ModeKind::vibration;
    if (with_shape) {
      const ComplexVector q = shape(r);
      m.field = field(r, q);
      m.shape = normalised(q);
      const Complex scale = m.kind == ModeKind::local ? largest_displacement(m.field) : largest_entry(q);
      for (ComplexMatrix& line : m.field) line /= scale;
    }
    return m;
  }

  // Displacement ζ + θ × p of every point, and what its appendage adds.
  std::vector<ComplexMatrix> field(const Root& r, const ComplexVector& q) const {
    std::vector<ComplexMatrix> all;
    const bool tilt = is_tilt(r);
    for (const auto& part : impedance_.parts()) {
      const auto lines = part.appendage->outlines();
      std::vector<ComplexMatrix> relative;
      if (!tilt) relative = part.appendage->displaced(r.omega, impedance_.body_vector(r.omega, r.vector), r.vector.segment(part.first, part.appendage->coordinates()));
      for (std::size_t i = 0; i < lines.size(); ++i) {
        ComplexMatrix d = tilt ? ComplexMatrix(ComplexMatrix::Zero(3, static_cast<Index>(lines[i].points.size()))) : ComplexMatrix(impedance_.unit_length() * relative[i]);
        for (Index k = 0; k < d.cols(); ++k) {
          d.col(k) += q.head<3>() + rotated(q.tail<3>(), impedance_.unit_length() * lines[i].points[static_cast<std::size_t>(k)]);
        }
        all.push_back(std::move(d));
      }
    }
    return all;
  }

  std::vector<ModelOutline> outlines() const {
    std::vector<ModelOutline> all;
    for (const auto& part : impedance_.parts()) {
      for (const Outline& o : part.appendage->outlines()) {
        ModelOutline line{o.name, {}};
        for (const Eigen::Vector3d& p : o.points) line.points.push_back(impedance_.unit_length() * p + Eigen::Vector3d(0, 0, spacecraft_.centre()));
        all.push_back(std::move(line));
      }
    }
    return all;
  }

  ComplexVector shape(const Root& r) const {
    if (body_at_rest(r)) return ComplexVector::Zero(6);
    if (!is_tilt(r)) return impedance_.body_motion(r.omega, r.vector);
    ComplexVector tilt = ComplexVector::Zero(6);
    tilt(3) = 1;
    tilt(4) = Complex(0, 1);
    return tilt;
  }

 private:
  const Spacecraft& spacecraft_;
  SpacecraftImpedance impedance_;
  Index neutral_;
  CertifiedRoots roots_;
};

// Roots in a little more than [a, b), so that what stands on an end is seen.
std::vector<Root> roots_around(const Solution& s, double a, double b) {
  constexpr double margin = 1e-9;
  std::vector<Root> all = s.roots().between(a * (1 - margin), b * (1 + margin));
  s.name_tilt(all);
  return all;
}

double open_error(const Root& r) { return std::max(r.error, 4 * std::numeric_limits<double>::epsilon() * r.omega); }

Window cleared(Window w, const std::vector<Root>& all) {
  for (auto r = all.rbegin(); r != all.rend() && w.a > 0; ++r) {
    if (std::abs(r->omega - w.a) <= 4 * open_error(*r)) w.a = std::max(0.0, r->omega - 16 * open_error(*r));
  }
  for (const Root& r : all) {
    if (std::abs(r.omega - w.b) <= 4 * open_error(r)) w.b = r.omega + 16 * open_error(r);
  }
  return w;
}

// Back in rad/s; an end that was not moved is exactly the one asked for.
Window in_units(const Window& w, double unit, const Window& requested) {
  return {w.a == requested.a / unit ? requested.a : w.a * unit, w.b == requested.b / unit ? requested.b : w.b * unit};
}

// A frequency above every mode of a body without booms: there J has counted each coordinate.
double above_all(const Solution& s) {
  const auto& blocked = s.roots().blocked();
  constexpr double farthest = 1e9;
  for (double b = 2; b < farthest; b *= 2) {
    const Lifted lifted = blocked.impedance.at(b);
    Index count = 0;
    for (const Block& block : blocked.blocks) count += state_of(block, lifted).count * block.copies();
    if (count == blocked.impedance.size()) return b;
  }
  return farthest;
}

// [0, b) with b in the gap after the `lowest`-th mode that is no rigid-body one.
Window lowest_window(const Solution& s, Index lowest, const Window& requested) {
  if (!s.impedance().continuous() && lowest >= s.impedance().size()) return {requested.a, std::min(requested.b, above_all(s))};
  const Index before = s.roots().below(requested.a);
  double b = std::max(2.0, 2 * requested.a);
  const double highest = std::min(requested.b, s.impedance().continuous() ? infinity : above_all(s));
  while (s.roots().below(b) - before < lowest + 3 && b < highest) b *= 1.5;  // the tilt is among them, and one more shows the gap
  const std::vector<Root> all = roots_around(s, requested.a, std::min(b, requested.b));
  Index seen = 0;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (all[i].omega < requested.a) continue;
    if (!s.is_tilt(all[i])) ++seen;
    const double from = all[i].omega + 4 * open_error(all[i]), to = all[i + 1].omega - 4 * open_error(all[i + 1]);
    if (seen >= lowest && to > from) return {requested.a, std::min(0.5 * (from + to), requested.b)};
  }
  return {requested.a, std::min(b, requested.b)};
}

Coverage coverage_of(const Solution& s, const Window& requested, const Window& window, const std::vector<Root>& inside) {
  Coverage c;
  c.requested = requested;
  c.window = window;
  const Index zeros = window.a == 0 ? s.zeros() : 0;
  c.found = static_cast<Index>(inside.size()) + zeros;
  if (!s.roots().closed()) {
    c.reason = s.roots().at_zero().doubtful ? "the static stiffness is singular to rounding" : "the index balance does not close: modes of negative energy or growing ones are missing";
    return c;
  }
  if ((window.a > 0 && s.roots().doubtful_at(window.a)) || s.roots().doubtful_at(window.b)) {
    c.reason = "an end of the window is on a root to rounding: move it";
    return c;
  }
  c.counted = s.roots().count(window.a, window.b) + zeros;
  c.status = *c.counted == c.found ? CoverageStatus::complete : CoverageStatus::incomplete;
  if (c.status == CoverageStatus::incomplete) c.reason = fmt::format("{} modes were found, the exact impedance counts {}", c.found, *c.counted);
  return c;
}

Mode zero_mode(Index label, bool with_shape) {
  Mode m;
  m.energy_sign = 0;
  m.kind = ModeKind::rigid_body;
  if (with_shape) {
    m.shape = ComplexVector::Zero(6);
    if (label >= 0) m.shape(label) = 1;
  }
  return m;
}

std::string path_of(const Solution& s) {
  Index real = 0, local = 0;
  const auto& blocks = s.roots().blocked().blocks;
  for (const Block& b : blocks) {
    real += b.real ? 1 : 0;
    local += b.coordinates.front() >= body_coordinates ? b.copies() : 0;
  }
  const Index all = static_cast<Index>(blocks.size());
  return fmt::format("exact fields, poles lifted: {} {} apart ({}{}), roots bisected on the count{}", all, all == 1 ? "block" : "blocks",
                     real == all ? "all real symmetric" : fmt::format("{} real symmetric, {} Hermitian", real, all - real),
                     local > 0 ? fmt::format(", {} boom patterns without the body", local) : "",
                     s.roots().needs_seeds() ? " with signs; negative energy and growth from a twin of finite elements, made exact" : "");
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

}  // namespace

Structure analyse(const Spacecraft& spacecraft, const StructureOptions&) {
  const SpacecraftImpedance impedance(spacecraft);
  return structure_of(BlockedImpedance(impedance));
}

ModesResult find_modes(const Spacecraft& spacecraft, const ModesOptions& options) {
  require_window(options.window);
  if (options.method != dense::Method::automatic) {
    throw dense::MethodDoesNotApply("the methods 'quadrature', 'general', 'first-order' and 'symmetric-2n' serve matrices; a spacecraft takes 'exact' or 'discrete'");
  }
  const Solution s(spacecraft);
  if (options.window.open() && !options.lowest && s.impedance().continuous()) {
    throw std::invalid_argument("a spacecraft with exact booms has infinitely many modes: a window with two ends or the number of lowest ones is needed");
  }
  const double unit = s.unit();
  Window window{options.window.a / unit, options.window.b / unit};
  if (window.open() && !s.impedance().continuous()) window.b = std::max(above_all(s), 2 * window.a);
  if (options.lowest) window = lowest_window(s, *options.lowest, window);
  const std::vector<Root> around = roots_around(s, window.a, window.b);
  window = cleared(window, around);
  std::vector<Root> inside;
  std::copy_if(around.begin(), around.end(), std::back_inserter(inside), [&](const Root& r) { return window.contains(r.omega); });

  ModesResult r;
  r.transcendental = true;
  r.structure = structure_of(s.roots().blocked());
  r.path = path_of(s);
  r.stability = s.stability();
  r.index_balance = s.balance();
  r.stiffness = {r.index_balance.negative > 0 ? Sign::indefinite : Sign::semidefinite, r.index_balance.negative, r.index_balance.zero};
  r.coverage = coverage_of(s, options.window, window, inside);
  r.coverage.window = in_units(window, unit, options.window);
  if (options.window.open() && !options.lowest) r.coverage.window.b = infinity;  // all of them
  if (options.shapes) r.outlines = s.outlines();
  if (window.a == 0) {
    r.modes.push_back(zero_mode(2, options.shapes));
    r.modes.push_back(zero_mode(5, options.shapes));
    for (Index k = spin_and_axial; k < s.zeros(); ++k) r.modes.push_back(zero_mode(-1, options.shapes));
  }
  for (const Root& root : inside) r.modes.push_back(s.mode(root, options.shapes));
  for (const Root& root : s.roots().negative_energy()) r.negative_modes.push_back(s.mode(root, false));
  for (const GrowingRoot& g : s.roots().growing()) {
    for (Index k = 0; k < g.copies; ++k) r.unstable.push_back({g.growth * unit, g.omega * unit});
  }
  std::sort(r.unstable.begin(), r.unstable.end(), [](const UnstableMode& a, const UnstableMode& b) { return a.growth_rate > b.growth_rate; });
  r.opposite_gap = infinity;
  return r;
}

CountResult count_modes(const Spacecraft& spacecraft, const Window& requested, const StructureOptions&) {
  require_window(requested);
  const Solution s(spacecraft);
  if (requested.open() && s.impedance().continuous()) throw std::invalid_argument("a spacecraft with exact booms has infinitely many modes: a window with two ends is needed");
  const double unit = s.unit();
  Window window{requested.a / unit, requested.b / unit};
  if (window.open()) window.b = std::max(above_all(s), 2 * window.a);
  constexpr double near = 1e-9;
  std::vector<Root> ends;
  for (const double end : {window.a, window.b}) {
    if (end == 0) continue;
    for (Root& r : s.roots().between(end * (1 - near), end * (1 + near))) ends.push_back(std::move(r));
  }
  const Window used = cleared(window, ends);
  CountResult c;
  c.requested = requested;
  c.window = in_units(used, unit, requested);
  if (requested.open()) c.window.b = infinity;
  const auto& blocked = s.roots().blocked();
  const auto negative = [&](double omega) {
    const Lifted lifted = blocked.impedance.at(omega);
    Index n = 0;
    for (std::size_t b = 0; b < blocked.blocks.size(); ++b) {
      n += (omega == 0 ? s.roots().at_zero().count[b] : state_of(blocked.blocks[b], lifted).count) * blocked.blocks[b].copies();
    }
    return n;
  };
  c.negative = {negative(used.a), negative(used.b)};
  c.signed_count = c.negative[1] - c.negative[0];
  c.zero = used.a == 0 ? s.zeros() : 0;
  const bool doubtful = s.roots().doubtful_at(used.b) || (used.a > 0 && s.roots().doubtful_at(used.a));
  c.status = doubtful ? CountStatus::doubtful : s.roots().closed() ? CountStatus::exact : CountStatus::signed_only;
  if (c.status == CountStatus::exact) c.count = s.roots().count(used.a, used.b) + c.zero;
  return c;
}

Transformation transformation_at(const Spacecraft& spacecraft, const Structure& structure, double omega) {
  return transformation_of(SpacecraftImpedance(spacecraft).hub(omega), structure, omega);
}

// ψ = ½ atan2(2c, a − d) of H = [a, c + jb; ·, d] (docs/booms.md (B13)). At Ω both vanish with a common factor, and for an axisymmetric H every angle serves: 0.
std::vector<EffectiveAxes> effective_axes(const Spacecraft& spacecraft, Index count) {
  const SpacecraftImpedance impedance(spacecraft);
  std::vector<EffectiveAxes> all;
  if (structure_of(BlockedImpedance(impedance)).system_class() == SystemClass::quadrature) return all;
  ModesOptions options;
  options.lowest = count;
  for (const Mode& m : find_modes(spacecraft, options).modes) {
    if (m.omega == 0) continue;
    constexpr double beside = 1e-6;
    const bool tilt = m.kind == ModeKind::rigid_body;
    const Eigen::Matrix2cd h = impedance.tilt(m.omega / spacecraft.spin() * (tilt ? 1 + beside : 1));
    const double difference = (h(0, 0) - h(1, 1)).real(), cross = h(0, 1).real();
    double angle = std::hypot(2 * cross, difference) <= 1e-13 * h.norm() ? 0 : 0.5 * std::atan2(2 * cross, difference);
    const double quarter = 0.25 * std::numbers::pi;
    if (angle > quarter) angle -= 2 * quarter;
    if (angle <= -quarter) angle += 2 * quarter;
    all.push_back({m.omega, angle});
  }
  return all;
}

ModesResult find_modes(const Spacecraft& spacecraft, const Mesh& mesh, const ModesOptions& options) {
  const System whole = discretise(spacecraft, mesh);
  const WithoutSpinPhase rest(whole, spin_phase);
  ModesResult r = find_modes(rest.system(), options);
  bool tilt_named = false;
  for (Mode& m : r.modes) {
    if (options.shapes) m.shape = normalised(rest.restored(m.shape, m.omega));
    if (tilt_named || !(std::abs(m.omega - spacecraft.spin()) <= 8 * m.error_bound + 1e-12 * spacecraft.spin())) continue;
    m.kind = ModeKind::rigid_body;
    tilt_named = true;
  }
  r.structure = analyse(whole, options.structure);
  r.index_balance.zero += 1;
  r.stiffness.zero += 1;
  if (r.stiffness.sign == Sign::positive) r.stiffness.sign = Sign::semidefinite;
  if (r.coverage.window.a == 0) {
    Mode spin;
    spin.kind = ModeKind::rigid_body;
    spin.energy_sign = 0;
    if (options.shapes) spin.shape = ComplexVector::Unit(whole.size(), spin_phase);
    r.modes.insert(r.modes.begin(), std::move(spin));
    r.coverage.found += 1;
    if (r.coverage.counted) *r.coverage.counted += 1;
  }
  r.path = fmt::format("finite elements ({} a cable, degree {}), spin phase apart: ", mesh.elements, mesh.degree) + r.path;
  return r;
}

}  // namespace gyromode
