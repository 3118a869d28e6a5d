#include "sensitivity.h"

#include "errors.h"

#include <fmt/format.h>

#include <sstream>

namespace gyromode::app {

namespace {

template <class Found>
std::vector<Sensitivity> answered(const std::optional<std::string>& asked, const Model& model, const Found& found) {
  if (!asked) return {};
  std::vector<std::string> keys;
  std::istringstream parts(*asked);
  for (std::string key; std::getline(parts, key, ',');) keys.push_back(key);
  try {
    return model.sensitivities(found, keys);
  } catch (const InvalidArgument& e) {
    throw UsageError(fmt::format("--sensitivity: {}", e.what()));
  }
}

}  // namespace

void SensitivityOption::add_to(CLI::App& verb) {
  verb.add_option("--sensitivity", asked,
                  "How much each number of the model moves each frequency, ∂ω/∂p and p/ω ∂ω/∂p: --sensitivity, or of these alone "
                  "--sensitivity=KEY,KEY ([*] for all items)")
      ->type_name("[=KEY,…]")
      ->expected(0, 1);
}

std::vector<Sensitivity> SensitivityOption::of(const Model& model, const std::vector<Mode>& modes) const {
  return answered(asked, model, modes);
}
std::vector<Sensitivity> SensitivityOption::of(const Model& model, const CriticalSpeeds& found) const {
  return answered(asked, model, found);
}

}  // namespace gyromode::app
