#include "gyromode/models/model.h"

#include "gyromode/base/error.h"
#include "gyromode/models/critical_in_fixed_axes.h"
#include "gyromode/models/matrices.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/models/spacecraft_model.h"
#include "gyromode/models/stability_over.h"
#include "gyromode/system/plausibility.h"

#include <cmath>

namespace gyromode {

Model::Model(std::shared_ptr<const ModelKind> kind_of_model, std::string word) : kind(std::move(word)), body(std::move(kind_of_model)) {}
Model::Model(System system) : Model(std::make_shared<MatricesModel>(std::move(system)), "matrices") {}
Model::Model(FirstOrderSystem system) : Model(std::make_shared<FirstOrderModel>(std::move(system)), "first_order") {}
Model::Model(SpinFamily family, double spin_of_axes)
    : Model(model_of({std::make_shared<const SpinFamily>(std::move(family)), spin_of_axes}), "matrices") {
  spin = spin_of_axes;
}
Model::Model(Spacecraft spacecraft) : Model(std::make_shared<SpacecraftModel>(std::move(spacecraft)), "spacecraft") {
  spin = static_cast<const SpacecraftModel&>(*body).spacecraft().spin();
  frame = Frame::turning;
}

std::string_view to_string(Frame frame) {
  switch (frame) {
    case Frame::turning: return "turning";
    case Frame::fixed: return "fixed";
    default: return "unknown";
  }
}

Index Model::size() const { return body->size(); }
const Labels& Model::labels() const { return body->labels(); }
ModesResult Model::modes(const ModesOptions& options) const { return body->modes(options); }
CountResult Model::count(const Window& window) const { return body->count(window); }
StabilityReport Model::stability(const Progress& progress) const { return body->stability(progress); }
StabilityMap Model::stability_over(const std::vector<ParameterAxis>& axes, const Progress& progress) const {
  return gyromode::stability_over(*body, axes, progress);
}
CriticalSpeeds Model::critical_speeds(const CriticalOptions& options) const {
  return frame == Frame::turning ? critical_speeds_from_turning_axes(*body, options) : body->critical_speeds(options);
}
std::vector<Sensitivity> Model::sensitivities(const std::vector<Mode>& modes, const std::vector<std::string>& keys) const {
  return gyromode::sensitivities(*body, modes, keys);
}
std::vector<Sensitivity> Model::sensitivities(const CriticalSpeeds& found, const std::vector<std::string>& keys) const {
  return gyromode::sensitivities(*body, found, body->speed_key(), keys);
}
Campbell Model::campbell(const CampbellOptions& options) const { return body->campbell(options); }
StructureReport Model::structure(std::optional<double> at) const { return body->structure(at); }
ResponseReport Model::response(const MotionRequest& request) const { return body->response(request); }
FrequencyReport Model::frequency_response(const FrequencyRequest& request) const { return body->frequency_response(request); }

UnbalanceReport Model::unbalance_response(const UnbalanceRequest& request) const {
  ModelKind::TurningForce f = body->unbalance(request.masses);
  if (frame == Frame::unknown)
    throw NotApplicable(
        "an unbalanced mass goes round in fixed axes and rests in turning ones: the model must say frame = \"fixed\" or \"turning\"");
  UnbalanceReport r;
  r.masses = request.masses;
  r.labels = labels();
  r.places = body->orbits();
  r.speed_ratio = f.speed_ratio;
  const double order = frame == Frame::turning ? f.speed_ratio - 1 : f.speed_ratio;
  if (order < 0) f.per_speed2 = f.per_speed2.conjugate().eval();
  if (order == 0) f.per_speed2 = f.per_speed2.real().cast<Complex>().eval();  // at rest, and real, in axes that turn with it
  r.response = synchronous_response(body->spin_source(), {std::move(f.per_speed2), std::abs(order)}, request.speeds, request.progress);
  return r;
}

std::vector<std::string> Model::doubts() const {
  std::vector<std::string> all = body->doubts(frame == Frame::fixed);
  for (std::string& doubt : doubts_on(labels())) all.push_back(std::move(doubt));
  return all;
}

std::vector<std::string> Model::doubts(const ModesResult& found) const {
  std::vector<double> frequencies;
  for (const Mode& m : found.modes) {
    if (m.omega > 0) frequencies.push_back(m.omega);
  }
  std::string doubt = doubt_on_unit(frequencies, known.frequencies);
  return doubt.empty() ? std::vector<std::string>{} : std::vector<std::string>{std::move(doubt)};
}

std::vector<Parameter> Model::parameters() const { return body->parameters(); }

Model Model::with(const std::vector<ParameterValue>& values) const {
  Model m = *this;
  m.body = body->with(values);
  const std::optional<Parameter> at = m.body->parameter("spin");
  m.spin = at ? std::optional(at->value) : std::nullopt;
  m.ignored = m.body->left_out();
  m.known = {};
  m.sha256.clear();
  return m;
}

Model Model::without_couplings(double tolerance) const {
  Model m = *this;
  auto [without, what] = body->without_couplings(tolerance);
  m.body = std::move(without);
  m.ignored = what;
  return m;
}

}  // namespace gyromode
