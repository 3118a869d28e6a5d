#pragma once

#include "gyromode/models/model.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace gyromode::app {

/// [--sensitivity[=KEY,KEY]].
struct SensitivityOption {
  std::optional<std::string> asked;

  void add_to(CLI::App& verb);
  /// Of the parameters named: all where none is; nothing where it was not asked for. Throws UsageError for a key that
  /// names none.
  std::vector<Sensitivity> of(const Model& model, const std::vector<Mode>& modes) const;
  std::vector<Sensitivity> of(const Model& model, const CriticalSpeeds& found) const;
};

}  // namespace gyromode::app
