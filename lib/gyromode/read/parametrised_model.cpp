#include "gyromode/read/parametrised_model.h"

#include "gyromode/base/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode::io {

std::vector<Parameter> ParametrisedModel::parameters() const {
  std::vector<Parameter> all = named_;
  for (Parameter& p : made()->parameters()) all.push_back(std::move(p));
  return all;
}

std::optional<Parameter> ParametrisedModel::parameter(std::string_view key) const {
  for (const Parameter& p : named_) {
    if (p.key == key) return p;
  }
  return made()->parameter(key);
}

// Named parameters first, as the numbers that formulas give are made of them; then those numbers that are asked for.
std::shared_ptr<const ModelKind> ParametrisedModel::with(const std::vector<ParameterValue>& values) const {
  std::vector<ParameterValue> named, numbers;
  for (const ParameterValue& v : values) {
    const bool known = std::any_of(named_.begin(), named_.end(), [&](const Parameter& p) { return p.key == v.key; });
    (known ? named : numbers).push_back(v);
  }
  for (std::size_t i = 0; i < named.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (named[k].key == named[i].key && named[k].value != named[i].value)
        throw InvalidArgument(fmt::format("'{}' is given two values at once", named[i].key));
    }
  }
  auto changed = std::make_shared<ParametrisedModel>(*this);
  if (!named.empty()) {
    for (const ParameterValue& v : given_) {
      const bool again = std::any_of(named.begin(), named.end(), [&](const ParameterValue& w) { return w.key == v.key; });
      if (!again) named.push_back(v);
    }
    Made made = maker_(named);
    if (tolerance_ > 0) made.model = made.model->without_couplings(tolerance_).first;
    changed->named_ = std::move(made.named);
    changed->answer_by(std::move(made.model));
    changed->given_ = std::move(named);
  }
  if (!numbers.empty()) changed->answer_by(changed->made()->with(numbers));
  return changed;
}

std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> ParametrisedModel::without_couplings(double tolerance) const {
  auto [reduced, what] = made()->without_couplings(tolerance);
  auto without = std::make_shared<ParametrisedModel>(*this);
  without->answer_by(std::move(reduced));
  without->tolerance_ = tolerance;
  return {std::move(without), what};
}

}  // namespace gyromode::io
