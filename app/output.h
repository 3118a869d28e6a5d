#pragma once

#include "gyromode/write/document.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <string>
#include <vector>

namespace gyromode::app {

/// Where a result goes and how it looks: [--format F] [-o FILE] [--units U] [--quiet] [--verbose].
struct OutputOption {
  std::string format, file, units;
  bool quiet = false, verbose = false;
  bool pictures = false;  ///< whether svg is among the formats

  void add_to(CLI::App& verb);
  Format chosen(Format otherwise = Format::table) const;  ///< `otherwise`: on stdout without --format
  /// With the unit asked for, or that of the frequencies on the command line, and what else stands there.
  Layout layout(Format otherwise = Format::table) const;
  /// Throws UsageError where the file is one of those read, or of a format that is not written.
  void require_place(const std::vector<std::string>& inputs) const;
  /// To stdout, or to the file, which is replaced only by a complete result.
  void write(const std::string& text) const;
  /// A line on stderr, unless --quiet.
  void say(const std::string& line) const;

 private:
  const CLI::App* verb_ = nullptr;
};

/// Seconds since it was made or last read.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double s = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return s;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace gyromode::app
