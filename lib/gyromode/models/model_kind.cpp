#include "gyromode/models/model_kind.h"

#include "gyromode/base/error.h"
#include "gyromode/models/parameter_keys.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode {

ModesResult ModelKind::verdict(bool with_shapes, const Progress& progress) const {
  ModesOptions options;
  options.progress = progress;
  options.shapes = with_shapes;
  if (!finite()) options.lowest = 1;  // the verdict needs no window
  return modes(options);
}

StabilityReport ModelKind::stability(const Progress& progress) const {
  StabilityReport r;
  r.result = verdict(true, progress);
  return r;
}

void ModelKind::require_motion() const {
  throw NotApplicable(
      fmt::format("response needs a model of second order, with displacements and velocities; this one is: {}", in_words()));
}

ResponseReport ModelKind::response(const MotionRequest&) const {
  require_motion();
  throw NotApplicable(fmt::format("no response is known of this kind of model: {}", in_words()));
}

FrequencyReport ModelKind::frequency_response(const FrequencyRequest&) const {
  throw NotApplicable("--frequencies is for matrix models of second order (gyromode convert writes the matrices of a spacecraft)");
}

CriticalSpeeds ModelKind::critical_speeds(const CriticalOptions&) const {
  throw NotApplicable(
      "critical speeds need a rotor, or matrices with 'spin' and 'gyroscopic_per_spin' (M, G₁, K₀, K₂): this model does not say how it "
      "depends on the speed");
}

ModelKind::TurningForce ModelKind::unbalance(const std::vector<Unbalance>&) const {
  throw NotApplicable("unbalance needs places that go round: a rotor, or matrices with 'orbits' = [[\"x1\", \"y1\"], …] in the model file");
}

namespace {

// Of every coordinate the real part of its term of XᴴAX, relative to the sum; not a number where that is 0.
Vector shares_of(const Matrix& a, const ComplexVector& x) {
  const Vector terms = x.real().cwiseProduct(a * x.real()) + x.imag().cwiseProduct(a * x.imag());
  const double sum = terms.sum();
  return std::abs(sum) > 1e-12 * terms.cwiseAbs().sum() ? Vector(terms / sum) : Vector::Constant(x.size(), std::nan(""));
}

}  // namespace

std::vector<EnergyShare> ModelKind::energy_shares(const Mode& mode, const std::vector<ModelOutline>&) const {
  const System* s = second_order();
  if (!s || s->size() != mode.shape.size() || !(mode.shape.squaredNorm() > 0)) return {};
  const Vector kinetic = shares_of(s->mass(), mode.shape), strain = shares_of(s->stiffness(), mode.shape);
  std::vector<EnergyShare> all;
  for (Index i = 0; i < s->size(); ++i) all.push_back({s->labels()[static_cast<std::size_t>(i)], kinetic(i), strain(i)});
  return all;
}

std::string ModelKind::name_of(const Mode&, const std::vector<EnergyShare>&) const { return {}; }

SpinSource ModelKind::spin_source() const {
  throw NotApplicable(
      "a sweep over the spin needs a rotor, a spacecraft, or matrices with 'spin' and 'gyroscopic_per_spin' or 'stiffness_per_spin2': "
      "this model does not say how it depends on the spin");
}

std::vector<double> ModelKind::divergence_thresholds(std::string_view, double, double) const { return {}; }

std::optional<Parameter> ModelKind::parameter(std::string_view key) const {
  for (Parameter& p : parameters()) {
    if (names(key, p.key)) return std::move(p);
  }
  return std::nullopt;
}

std::shared_ptr<const ModelKind> ModelKind::with(const std::vector<ParameterValue>& values) const {
  throw InvalidArgument(fmt::format("'{}' is no parameter: this kind of model has none", values.empty() ? "" : values.front().key));
}

std::vector<Matrix> ModelKind::matrices_with(const std::vector<ParameterValue>& values) const {
  std::vector<Matrix> all;
  const auto changed = with(values);
  for (const NamedMatrix& m : changed->matrices()) all.push_back(*m.matrix);
  return all;
}

std::shared_ptr<const ModelKind> ModelKind::discretised(std::optional<Index>) const {
  throw NotApplicable(
      "finite elements (--method discrete, --elements) serve models of parts, such as spacecraft; this one is made of matrices");
}

std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> ModelKind::without_couplings(double) const {
  throw NotApplicable("--coupling-tolerance is for matrix models: the couplings of a spacecraft follow from its parts");
}

}  // namespace gyromode
