#include "gyromode/models/stability_over.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/sweep/encounters.h"
#include "gyromode/sweep/spin_track.h"

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

// Where branches over the spin, followed in a family of matrices, begin or end to flutter, or the index balance of
// neighbouring spins that this looked at differs; none where the parameter is another, or nothing can be followed.
std::vector<double> flutter_over_spin(const ModelKind& model, const ParameterAxis& axis, const Progress& progress) {
  constexpr Index largest = 200;  // coordinates: every spin is solved whole
  if (axis.keys != model.speed_key() || axis.values.size() < 2 || model.size() > largest) return {};
  try {
    const SpinSource source = model.spin_source();
    if (!source.family) return {};
    Progress quiet;
    quiet.stop = progress.stop;
    const SpinSampler sampler(source, {infinity, model.size()}, axis.values.front(), axis.values.back());
    SpinTrack track(sampler, axis.values, quiet);
    std::vector<double> all;
    for (const Encounter& e : encounters(track)) {
      if (e.flutter) all.insert(all.end(), e.flutter->begin(), e.flutter->end());
    }
    const SpinSample* before = nullptr;
    for (const auto& [spin, point] : track.points()) {
      const IndexBalance& b = point.sample.balance;
      if (before && (b.quadruples != before->balance.quadruples || b.real_pairs != before->balance.real_pairs))
        all.push_back(0.5 * (before->spin + spin));
      before = &point.sample;
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
