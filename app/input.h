#pragma once

#include "output.h"

#include "gyromode/io/model.h"
#include "gyromode/modes/window.h"
#include "gyromode/structure/structure.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace gyromode::app {

/// Where a model comes from: a TOML file, or three Matrix Market files.
struct ModelSource {
  std::string model, mass, gyroscopic, stiffness;
  double coupling_tolerance = 0;

  /// `tolerant`: with --coupling-tolerance, for verbs that look at the structure.
  void add_to(CLI::App& verb, bool tolerant = true);
  io::Model read() const;
  /// Says on stderr that couplings are left out, for verbs whose result does not.
  void remark_on_tolerance(const OutputOption& output) const;
  StructureOptions structure() const { return {coupling_tolerance}; }
};

/// A window of frequencies, as [--below W | --window A:B].
struct WindowOption {
  std::string below, window;

  void add_to(CLI::App& verb);
  bool given() const { return !below.empty() || !window.empty(); }
  Window read() const;
};

/// A frequency as on the command line: a bare number is rad/s; 5Hz, 300rpm. Throws UsageError naming the option.
double frequency_option(const std::string& option, const std::string& text);

}  // namespace gyromode::app
