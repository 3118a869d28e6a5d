#include "gyromode/models/stability_over.h"

#include "gyromode/base/error.h"

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

}  // namespace

StabilityMap stability_over(const ModelKind& model, const std::vector<ParameterAxis>& axes, const Progress& progress) {
  if (axes.size() > 2) throw InvalidArgument("a map has one parameter or two");
  std::vector<std::vector<double>> values;
  for (const ParameterAxis& axis : axes) {
    require_parameter(model, axis.keys);
    values.push_back(axis.values);
  }
  const Thresholds thresholds = [&](const std::vector<double>& others) -> std::vector<double> {
    const auto& first = axes.front();
    if (keys_of(first.keys).size() != 1) return {};
    std::shared_ptr<const ModelKind> at;
    if (!others.empty()) {
      std::vector<ParameterValue> rest;
      for (const std::string& key : keys_of(axes[1].keys)) rest.push_back({key, others[0]});
      try {
        at = model.with(rest);
      } catch (const Error&) {  // no model there
        return {};
      }
    }
    return (at ? *at : model).divergence_thresholds(first.keys, first.values.front(), first.values.back());
  };
  return map_stability([&](const std::vector<double>& at) { return verdict_at(model, axes, at); }, std::move(values), progress, thresholds);
}

}  // namespace gyromode
