// The parameters of models made of matrices.
#include "gyromode/models/condensed_model.h"
#include "gyromode/models/family_parameters.h"
#include "gyromode/models/matrices.h"

#include "gyromode/base/error.h"
#include "gyromode/models/parameter_keys.h"

#include <fmt/format.h>

#include <utility>

namespace gyromode {

namespace {

std::vector<MatrixOfParameters> entries_of(SpinFamily& f) {
  std::vector<MatrixOfParameters> all{{"mass", &f.mass}, {"gyroscopic", &f.gyroscopic, true}, {"stiffness", &f.stiffness}};
  if (f.gyroscopic_per_spin.size() > 0) all.push_back({"gyroscopic_per_spin", &f.gyroscopic_per_spin, true});
  if (f.stiffness_per_spin2.size() > 0) all.push_back({"stiffness_per_spin2", &f.stiffness_per_spin2});
  return all;
}

void require(bool named, const ParameterValue& value) {
  if (!named) throw InvalidArgument(fmt::format("'{}' is no parameter of the model", value.key));
}

void require_kept(bool kept, const ParameterValue& value) {
  if (!kept)
    throw InvalidArgument(fmt::format("'{}' is given two values at once: another key names it, or its mirror image, too", value.key));
}

// The parameters of the whole model, where couplings were left out, and those couplings left out again.
template <class Kind>
std::shared_ptr<const ModelKind> with_couplings_left_out(const CouplingsLeftOut<Kind>& left_out,
                                                         const std::vector<ParameterValue>& values) {
  return left_out.whole->with(values)->without_couplings(left_out.tolerance).first;
}

}  // namespace

std::vector<Parameter> FamilyAtSpin::parameters() const {
  std::vector<Parameter> all;
  if (spin) all.push_back({"spin", Dimension::frequency, *spin});
  SpinFamily f = *family;
  for (Parameter& p : listed_entries(entries_of(f))) all.push_back(std::move(p));
  return all;
}

std::vector<Parameter> FamilyAtSpin::named() const {
  return spin ? std::vector<Parameter>{{"spin", Dimension::frequency, *spin}} : std::vector<Parameter>{};
}

std::optional<Parameter> FamilyAtSpin::parameter(std::string_view key) const {
  if (key == "spin") return spin ? std::optional(Parameter{"spin", Dimension::frequency, *spin}) : std::nullopt;
  SpinFamily f = *family;
  return entry_named(entries_of(f), key);
}

FamilyAtSpin FamilyAtSpin::with(const std::vector<ParameterValue>& values) const {
  std::optional<double> at = spin;
  SpinFamily f = *family;
  for (const ParameterValue& v : values) {
    const bool is_spin = v.key == "spin" && spin;
    if (is_spin) at = v.value;
    require(is_spin || set_entries(entries_of(f), v), v);
  }
  for (const ParameterValue& v : values) require_kept(v.key == "spin" && spin ? *at == v.value : entries_have(entries_of(f), v), v);
  return {std::make_shared<const SpinFamily>(std::move(f)), at, orbits};
}

SpinSource spin_source_of(std::shared_ptr<const SpinFamily> family, std::vector<OrbitCoordinates> places,
                          std::vector<OrbitCoordinates> transverse) {
  SpinSource source;
  source.modes = [family](double spin, const ModesOptions& options) { return model_of({family, spin, {}})->modes(options); };
  source.family = std::move(family);
  source.places = std::move(places);
  source.transverse = std::move(transverse);
  return source;
}

std::shared_ptr<const ModelKind> model_of(FamilyAtSpin matrices) {
  const SpinFamily::Sum sum = matrices.family->sum(matrices.spin.value_or(0));
  if (auto c = condensation(matrices.family->mass, sum.gyroscopic, sum.stiffness, matrices.family->labels, matrices.family->admission))
    return std::make_shared<CondensedModel>(std::move(matrices), std::move(*c));
  return std::make_shared<MatricesModel>(std::move(matrices));
}

FamilyAtSpin MatricesModel::matrices_at_spin() const {
  if (matrices_.family) return matrices_;
  return {std::make_shared<const SpinFamily>(
              SpinFamily{system_.mass(), system_.gyroscopic(), {}, system_.stiffness(), {}, system_.labels(), {}}),
          std::nullopt};
}

std::vector<Parameter> MatricesModel::parameters() const {
  return left_out_.whole ? left_out_.whole->parameters() : matrices_at_spin().parameters();
}

std::vector<Parameter> MatricesModel::named_parameters() const {
  return left_out_.whole ? left_out_.whole->named_parameters() : matrices_.named();
}

std::vector<Parameter> FirstOrderModel::named_parameters() const { return {}; }

std::optional<Parameter> MatricesModel::parameter(std::string_view key) const {
  return left_out_.whole ? left_out_.whole->parameter(key) : matrices_at_spin().parameter(key);
}

std::shared_ptr<const ModelKind> MatricesModel::with(const std::vector<ParameterValue>& values) const {
  if (left_out_.whole) return with_couplings_left_out(left_out_, values);
  FamilyAtSpin changed = matrices_at_spin().with(values);
  if (matrices_.family) return model_of(std::move(changed));
  const SpinFamily& f = *changed.family;  // a System that was given as such keeps its repairs
  return std::make_shared<MatricesModel>(system_.replaced(f.mass, f.gyroscopic, f.stiffness));
}

std::vector<Parameter> FirstOrderModel::parameters() const {
  if (left_out_.whole) return left_out_.whole->parameters();
  Matrix inertia = system_.inertia(), gyroscopic = system_.gyroscopic();
  return listed_entries({{"inertia", &inertia}, {"gyroscopic", &gyroscopic, true}});
}

std::optional<Parameter> FirstOrderModel::parameter(std::string_view key) const {
  if (left_out_.whole) return left_out_.whole->parameter(key);
  Matrix inertia = system_.inertia(), gyroscopic = system_.gyroscopic();
  return entry_named({{"inertia", &inertia}, {"gyroscopic", &gyroscopic, true}}, key);
}

std::shared_ptr<const ModelKind> FirstOrderModel::with(const std::vector<ParameterValue>& values) const {
  if (left_out_.whole) return with_couplings_left_out(left_out_, values);
  Matrix inertia = system_.inertia(), gyroscopic = system_.gyroscopic();
  const std::vector<MatrixOfParameters> entries{{"inertia", &inertia}, {"gyroscopic", &gyroscopic, true}};
  for (const ParameterValue& v : values) require(set_entries(entries, v), v);
  for (const ParameterValue& v : values) require_kept(entries_have(entries, v), v);
  return std::make_shared<FirstOrderModel>(system_.replaced(std::move(inertia), std::move(gyroscopic)));
}

}  // namespace gyromode
