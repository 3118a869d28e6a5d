#include "gyromode/models/condensed_model.h"

#include "gyromode/base/error.h"
#include "gyromode/models/unbalance.h"
#include "gyromode/lapack/small.h"
#include "gyromode/models/response_facts.h"
#include "gyromode/modes/condensed.h"
#include "gyromode/modes/shape.h"
#include "gyromode/stability/stability_margin.h"
#include "gyromode/structure/inertia_of_k.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace gyromode {

namespace {

// The massive entries of a vector of all, where the others are zero.
Vector massive_part(const Condensation& c, const Vector& all, std::string_view what) {
  for (const Index i : c.massless) {
    if (all(i) == 0) continue;
    throw NotApplicable(
        fmt::format("'{}' has no mass: its {} cannot be given, it follows from the other coordinates; give it some mass, or let "
                    "it be",
                    c.labels[static_cast<std::size_t>(i)], what));
  }
  return all(c.massive);
}

}  // namespace

CondensedModel::CondensedModel(FamilyAtSpin matrices, Condensation condensation)
    : matrices_(std::move(matrices)), c_(std::move(condensation)) {}

Labels CondensedModel::massless() const {
  Labels names;
  for (const Index i : c_.massless) names.push_back(c_.labels[static_cast<std::size_t>(i)]);
  return names;
}

// Shapes in all coordinates; and to the error bounds what forming M', G', K' rounded: |X|ᵀ(δK + ωδG + ω²δM)|X| /
// |form|.
void CondensedModel::expand(std::vector<Mode>& modes) const {
  for (Mode& m : modes) {
    if (m.form != 0) {
      const Vector size = m.shape.cwiseAbs();
      const double off = size.dot(c_.rounded_stiffness * size) + m.omega * size.dot(c_.rounded_gyroscopic * size) +
                         m.omega * m.omega * size.dot(c_.rounded_mass * size);
      m.error_bound += off / std::abs(m.form);
    }
    ComplexVector all = c_.expanded(Complex(0, m.omega), m.shape);
    m.form /= std::norm(largest_entry(all));
    m.shape = normalised(std::move(all));
  }
}

void CondensedModel::to_all(Structure& s) const {
  const auto to_all = [&](std::vector<Index>& positions) {
    for (Index& i : positions) i = c_.massive[static_cast<std::size_t>(i)];
  };
  for (Component& c : s.components) {
    to_all(c.coordinates);
    to_all(c.in_phase);
    to_all(c.in_quadrature);
    if (c.odd_cycle) to_all(c.odd_cycle->coordinates);
  }
}

ModesResult CondensedModel::expanded(ModesResult r, bool with_shapes) const {
  expand(r.modes);
  expand(r.negative_modes);
  for (UnstableMode& u : r.unstable) u.shape = normalised(c_.expanded(Complex(u.growth_rate, u.omega), u.shape));
  if (!with_shapes) {
    for (std::vector<Mode>* modes : {&r.modes, &r.negative_modes}) {
      for (Mode& m : *modes) m.shape.resize(0), m.form = 0;
    }
    for (UnstableMode& u : r.unstable) u.shape.resize(0);
  }
  to_all(r.structure);
  r.solver += fmt::format("; {} of {} coordinates have no mass and follow the others", c_.massless.size(), c_.labels.size());
  return r;
}

ModesResult CondensedModel::modes(const ModesOptions& options) const {
  const Labels without = massless();
  for (const std::string& label : options.keep) {
    if (std::find(without.begin(), without.end(), label) != without.end())
      throw NotApplicable(fmt::format("keep: '{}' has no mass and follows the other coordinates: keep some that have", label));
  }
  ModesOptions with_shapes = options;
  with_shapes.shapes = true;
  return expanded(find_modes(c_, with_shapes), options.shapes);
}

CountResult CondensedModel::count(const Window& window) const { return count_modes(c_.reduced, window); }

StabilityReport CondensedModel::stability(const Progress& progress) const {
  StabilityReport r = ModelKind::stability(progress);
  r.opposite = nearest_opposite_pair(r.result.modes);
  r.stiffness = stiffness_margin(c_.reduced, r.result.stiffness.zero);
  return r;
}

CriticalSpeeds CondensedModel::critical_speeds(const CriticalOptions& options) const {
  if (!matrices_.family || !matrices_.spin) return ModelKind::critical_speeds(options);
  return gyromode::critical_speeds(*matrices_.family, options, matrices_.orbits);
}

std::vector<Parameter> CondensedModel::named_parameters() const { return matrices_.named(); }

ModelKind::TurningForce CondensedModel::unbalance(const std::vector<Unbalance>& masses) const {
  return matrices_.orbits.empty() ? ModelKind::unbalance(masses) : unbalance_at(matrices_.orbits, labels(), masses);
}

SpinSource CondensedModel::spin_source() const {
  return matrices_.family && matrices_.spin ? spin_source_of(matrices_.family, matrices_.orbits, matrices_.orbits)
                                            : ModelKind::spin_source();
}

StructureReport CondensedModel::structure(std::optional<double> at) const {
  if (at)
    throw NotApplicable("--at: H(ω) of a model with massless coordinates is that of its condensed matrices, which gyromode convert writes");
  StructureReport r;
  r.structure = analyse(c_.reduced, HiddenSearch::always);
  r.stiffness = inertia_of_k(c_.reduced.stiffness());
  to_all(r.structure);
  r.repairs = c_.repairs;
  return r;
}

ResponseReport CondensedModel::response(const MotionRequest& request) const {
  if (!request.points.empty()) throw InvalidArgument("--points are places on the booms of a spacecraft model");
  const State initial{massive_part(c_, request.initial.q, "displacement at the start"),
                      massive_part(c_, request.initial.qdot, "velocity at the start")};
  std::vector<Force> forces = request.forces;
  for (Force& f : forces) f.amplitude = massive_part(c_, f.amplitude, "force");
  const Response r(c_.reduced, initial, forces);
  ResponseReport report;
  add_facts(r, r, request, report);
  report.labels = c_.labels;
  History& h = report.history;
  Matrix all_q(size(), h.t.size()), all_rates(size(), h.t.size());
  for (Index k = 0; k < h.t.size(); ++k) {
    const Vector q = h.q.col(k), rate = h.qdot.col(k);
    Vector right = -(c_.reduced.gyroscopic() * rate) - c_.reduced.stiffness() * q;
    for (const Force& f : forces) {
      if (f.course == Force::Course::step) right += f.amplitude;
      if (f.course == Force::Course::harmonic) right += f.amplitude * std::cos(f.frequency * h.t(k));
    }
    const Vector acceleration = small::solve(c_.reduced.mass(), Matrix(right));
    all_q(c_.massive, k) = q;
    all_rates(c_.massive, k) = rate;
    all_q(c_.massless, k) = -(c_.follow * q) - c_.follow_rate * rate;
    all_rates(c_.massless, k) = -(c_.follow * rate) - c_.follow_rate * acceleration;
  }
  h.q = std::move(all_q);
  h.qdot = std::move(all_rates);
  for (ModalShare& m : report.modal) {  // the coordinate whose entry is 1 may be another one now
    ComplexVector all = c_.expanded(Complex(0, m.omega), m.shape);
    const Complex largest = largest_entry(all);
    m.amplitude *= std::abs(largest);
    m.phase = std::arg(std::polar(1.0, m.phase) * largest);
    m.shape = normalised(std::move(all));
  }
  report.keep_only(request.chosen, size());
  return report;
}

std::shared_ptr<const ModelKind> CondensedModel::with(const std::vector<ParameterValue>& values) const {
  return model_of(matrices_.with(values));
}

std::vector<ModelKind::NamedMatrix> CondensedModel::matrices() const {
  return {{"M", "mass M, condensed", false, &c_.reduced.mass()},
          {"G", "gyroscopic G, condensed", true, &c_.reduced.gyroscopic()},
          {"K", "stiffness K, condensed", false, &c_.reduced.stiffness()}};
}

}  // namespace gyromode
