#pragma once

#include "gyromode/read/read_model.h"
#include "gyromode/spectrum/window.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace gyromode::app {

/// Where a model comes from, a TOML file or matrix files, and what is asked of it at the door.
struct ModelSource {
  std::string model, mass, gyroscopic, stiffness, container, labels;
  std::vector<std::string> names;
  double coupling_tolerance = 0;
  std::optional<std::string> symmetrise;
  bool strict = false;
  std::optional<std::string> memory, scratch;  ///< for factorisations

  void add_to(CLI::App& verb);
  /// The files that are read.
  std::vector<std::string> files() const { return {model, mass, gyroscopic, stiffness, container, labels}; }
  /// The model as every verb sees it: read, and without the couplings that are to be left out.
  Model read() const;
  /// The same of a model already made: its system without those couplings. Throws NotApplicable for a spacecraft, whose
  /// couplings follow from its parts.
  Model admitted(Model model) const;

 private:
  Admission admission() const;
  void limit_memory() const;
  void name_matrices(MatrixFiles& files) const;
};

/// Modes that are found where neither a window nor a number is given of a model that has infinitely many, or is
/// searched window by window.
constexpr Index lowest_by_default = 10;

/// A window of frequencies, as [--below W | --window A:B].
struct WindowOption {
  std::optional<std::string> below, window;

  void add_to(CLI::App& verb);
  bool given() const { return below || window; }
  Window read() const;
};

/// A frequency as on the command line: a bare number is rad/s; 5Hz, 300rpm. Throws UsageError naming the option.
double frequency_option(const std::string& option, const std::string& text);

/// A check of an option that counts something: a whole number above 0.
CLI::Validator whole_above_zero();

}  // namespace gyromode::app
