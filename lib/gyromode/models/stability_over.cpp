#include "gyromode/models/stability_over.h"

#include "gyromode/base/error.h"
#include "gyromode/sweep/campbell.h"

namespace gyromode {

namespace {

StabilityPoint verdict_at(const ModelKind& model, const std::vector<ParameterAxis>& axes, const std::vector<double>& at) {
  std::vector<ParameterValue> values;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    for (const std::string& key : keys_of(axes[k].keys)) values.push_back({key, at[k]});
  }
  const auto no_model = [](const Error& e) {
    StabilityPoint p;
    p.law_kept = false;
    p.reason = e.what();
    return p;
  };
  try {
    return stability_point(model.with(values)->verdict(false));
  } catch (const LawBroken& e) {
    return no_model(e);
  } catch (const Unreadable& e) {  // a formula that is no number there
    return no_model(e);
  }
}

// The ends of the intervals of flutter that branches over the spin show, of a family of matrices; none where the
// parameter is another, or nothing can be followed.
std::vector<double> flutter_over_spin(const ModelKind& model, const ParameterAxis& axis, const Progress& progress) {
  constexpr Index largest = 200;  // coordinates: every spin is solved whole
  if (axis.keys != model.speed_key() || axis.values.size() < 2 || model.size() > largest) return {};
  try {
    const SpinSource source = model.spin_source();
    if (!source.family) return {};
    CampbellOptions o;
    o.spins = axis.values;
    o.lowest = model.size();
    o.orders.clear();
    o.progress.stop = progress.stop;
    std::vector<double> all;
    for (const Encounter& e : campbell(source, o).encounters) {
      if (e.flutter) all.insert(all.end(), e.flutter->begin(), e.flutter->end());
    }
    return all;
  } catch (const Error&) {  // no such family, or no mode at a spin
    return {};
  }
}

}  // namespace

StabilityMap stability_over(const ModelKind& model, const std::vector<ParameterAxis>& axes, const Progress& progress) {
  if (axes.empty() || axes.size() > 2) throw InvalidArgument("a map has one parameter or two");
  std::vector<std::vector<double>> values;
  for (const ParameterAxis& axis : axes) {
    require_parameter(model, axis.keys);
    values.push_back(axis.values);
  }
  const ParameterAxis& first = axes.front();
  // What the model at the value of the second parameter says of the first.
  const auto of_row = [&](const std::vector<double>& others, const auto& say) -> std::vector<double> {
    if (keys_of(first.keys).size() != 1) return {};
    if (others.empty()) return say(model);
    std::vector<ParameterValue> rest;
    for (const std::string& key : keys_of(axes[1].keys)) rest.push_back({key, others[0]});
    std::shared_ptr<const ModelKind> at;
    try {
      at = model.with(rest);
    } catch (const Error&) {  // no model there
      return {};
    }
    return say(*at);
  };
  const Thresholds thresholds = [&](const std::vector<double>& others) {
    return of_row(others,
                  [&](const ModelKind& m) { return m.divergence_thresholds(first.keys, first.values.front(), first.values.back()); });
  };
  const Thresholds flutter = [&](const std::vector<double>& others) {
    return of_row(others, [&](const ModelKind& m) { return flutter_over_spin(m, first, progress); });
  };
  return map_stability([&](const std::vector<double>& at) { return verdict_at(model, axes, at); }, std::move(values), progress, thresholds,
                       flutter);
}

}  // namespace gyromode
